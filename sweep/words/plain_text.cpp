#include "sweep/words/plain_text.h"

#include <array>
#include <string_view>
#include <utility>

namespace stickslip {
namespace {

/// A whole number in raised digits, as of 10⁻⁶; empty for any other exponent.
std::string exponent(std::string_view number)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> raised{{{"−", "⁻"},
                                                                                           {"0", "⁰"},
                                                                                           {"1", "¹"},
                                                                                           {"2", "²"},
                                                                                           {"3", "³"},
                                                                                           {"4", "⁴"},
                                                                                           {"5", "⁵"},
                                                                                           {"6", "⁶"},
                                                                                           {"7", "⁷"},
                                                                                           {"8", "⁸"},
                                                                                           {"9", "⁹"}}};
    std::string text;
    while (!number.empty()) {
        bool known = false;
        for (const auto& [digit, small] : raised)
            if (number.starts_with(digit)) {
                text += small;
                number.remove_prefix(digit.size());
                known = true;
                break;
            }
        if (!known) return "";
    }
    return text;
}

}  // namespace

std::string plain_text(const std::string& markup)
{
    std::string text;
    for (std::size_t i = 0; i < markup.size(); ++i) {
        const bool opens = (markup[i] == '_' || markup[i] == '^') && i + 1 < markup.size() && markup[i + 1] == '{';
        const auto end = opens ? markup.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            text += markup[i];
            continue;
        }
        const std::string inside = markup.substr(i + 2, end - i - 2);
        const std::string raised = markup[i] == '^' ? exponent(inside) : "";
        text += raised.empty() ? markup[i] + inside : raised;
        i = end;
    }
    return text;
}

}  // namespace stickslip
