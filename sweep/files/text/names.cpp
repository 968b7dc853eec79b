#include "sweep/files/text/names.h"

#include "analysis/joint/parameters.h"

namespace stickslip::files {

std::string did_you_mean(std::string_view given, const std::vector<std::string>& known)
{
    const auto near = nearest_names(given, known);
    return near.empty() ? "" : "; did you mean \"" + near.front() + "\"?";
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

}  // namespace stickslip::files
