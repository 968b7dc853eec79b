#include "sweep/words/plain_text.h"

namespace stickslip {

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
        text += markup[i] + markup.substr(i + 2, end - i - 2);
        i = end;
    }
    return text;
}

}  // namespace stickslip
