#include "render/drawing/markup.h"

#include <algorithm>

namespace stickslip::drawing {

std::vector<Run> parse_markup(std::string_view markup)
{
    std::vector<Run> runs;
    const auto add = [&runs](std::string_view text, Run::Level level) {
        if (text.empty()) return;
        if (!runs.empty() && runs.back().level == level)
            runs.back().text += text;
        else
            runs.push_back({std::string(text), level});
    };
    while (!markup.empty()) {
        const std::size_t mark = std::min(markup.find("_{"), markup.find("^{"));
        const std::size_t close = mark == std::string_view::npos ? mark : markup.find('}', mark);
        if (close == std::string_view::npos) {
            add(markup, Run::Level::base);
            break;
        }
        add(markup.substr(0, mark), Run::Level::base);
        add(markup.substr(mark + 2, close - mark - 2),
            markup[mark] == '_' ? Run::Level::subscript : Run::Level::superscript);
        markup.remove_prefix(close + 1);
    }
    return runs;
}

std::string plain_text(std::string_view markup)
{
    std::string text;
    for (const Run& run : parse_markup(markup)) text += run.text;
    return text;
}

}  // namespace stickslip::drawing
