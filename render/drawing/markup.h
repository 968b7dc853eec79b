// The small mark-up of labels: "k_{p}" is a subscript, "10^{−6}" a superscript, and nothing else means anything.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::drawing {

/// A stretch of text on one level.
struct Run {
    enum class Level { base, subscript, superscript };
    std::string text;
    Level level = Level::base;

    bool operator==(const Run&) const = default;
};

/// Splits mark-up into runs. An underscore or caret without "{…}" after it is ordinary text; so is an unclosed brace.
std::vector<Run> parse_markup(std::string_view markup);

/// The words alone, "k_{p}" → "kp": for names of files, columns and spoken labels.
std::string plain_text(std::string_view markup);

}  // namespace stickslip::drawing
