#include "sweep/program/verbs/word_option.h"

#include "analysis/joint/parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

/// In the help: "{a,b}".
std::string in_braces(const std::vector<std::string>& words)
{
    return fmt::format("{{{}}}", fmt::join(words, ","));
}

std::string not_among(const std::string& given, const std::vector<std::string>& words, const char* or_else)
{
    return "got " + in_quotes(given) + ", expected " + listed(words) + or_else + did_you_mean(given, words);
}

}  // namespace

std::string in_quotes(const std::string& text)
{
    return '"' + text + '"';
}

std::string listed(const std::vector<std::string>& names)
{
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& known)
{
    auto near = nearest_names(given, known);
    if (near.empty() && !given.empty())
        for (const auto& name : known)
            if (name.starts_with(given)) near.push_back(name);
    return near.empty() ? "" : "; did you mean " + near.front() + "?";
}

Check one_of(const std::vector<std::string>& words)
{
    return {[words](const std::string& given) {
                return std::ranges::count(words, given) > 0 ? std::string() : not_among(given, words, "");
            },
            in_braces(words)};
}

Check one_of_or_file(const std::vector<std::string>& words)
{
    return {[words](const std::string& given) {
                const bool known = std::ranges::count(words, given) > 0 || existing_file().complaint(given).empty();
                return known ? std::string() : not_among(given, words, " or a file");
            },
            "(" + in_braces(words) + ") OR (FILE)"};
}

}  // namespace stickslip
