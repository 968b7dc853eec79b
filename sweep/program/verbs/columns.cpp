#include "sweep/program/verbs/columns.h"

#include <algorithm>
#include <vector>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::vector<std::string>;

constexpr std::size_t widest = 40;  ///< letters of a column, unless a word is longer

/// Letters, not bytes: UTF-8 goes on with 10xxxxxx.
std::size_t letters(const std::string& text)
{
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string cell(const Json& value)
{
    return value.is_boolean() ? std::string(value.get<bool>() ? "yes" : "no") : value.get<std::string>();
}

Lines wrapped(const std::string& text)
{
    Lines lines{""};
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const bool fits = lines.back().empty() || letters(lines.back()) + 1 + letters(word) <= widest;
        if (!fits) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        at = end + 1;
    }
    return lines;
}

}  // namespace

std::string columns_text(Json list)
{
    if (list.empty()) return "";
    Json heading;
    for (const auto& [key, value] : list[0].items()) {
        std::string words = key;
        std::replace(words.begin(), words.end(), '_', ' ');
        heading[key] = words;
    }
    list.insert(list.begin(), heading);
    std::vector<std::vector<Lines>> rows;
    std::vector<std::size_t> widths;
    for (const auto& entry : list) {
        auto& row = rows.emplace_back();
        for (const auto& value : entry) {
            row.push_back(wrapped(cell(value)));
            if (widths.size() < row.size()) widths.push_back(0);
            for (const auto& line : row.back())
                widths[row.size() - 1] = std::max(widths[row.size() - 1], letters(line));
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::size_t height = 1;
        for (const auto& lines : row) height = std::max(height, lines.size());
        for (std::size_t i = 0; i < height; ++i) {
            std::string line;
            for (std::size_t column = 0; column < row.size(); ++column) {
                const std::string part = i < row[column].size() ? row[column][i] : "";
                line += part + std::string(widths[column] - letters(part) + 2, ' ');
            }
            line.erase(line.find_last_not_of(' ') + 1);
            text += line + "\n";
        }
    }
    return text;
}

}  // namespace stickslip
