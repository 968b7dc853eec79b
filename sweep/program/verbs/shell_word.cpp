#include "sweep/program/verbs/shell_word.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace stickslip {

std::string shell_word(const std::string& text)
{
    constexpr std::string_view harmless = "_-./,:=+@%";
    const auto safe = [&](unsigned char c) { return std::isalnum(c) || harmless.find(c) != std::string_view::npos; };
    if (!text.empty() && std::ranges::all_of(text, safe)) return text;
    std::string word = "'";
    for (const char c : text)
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    return word + "'";
}

}  // namespace stickslip
