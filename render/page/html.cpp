#include "render/page/html.h"

#include "render/drawing/encode.h"
#include "render/drawing/markup.h"
#include "render/page/typeset.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>

namespace stickslip::drawing {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

/// Bytes of the well-formed UTF-8 character at the front, 0 where there is none.
std::size_t character_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool outside = (first == 0xed && byte(1) > 0x9f) || (first == 0xf4 && byte(1) > 0x8f);
    return overlong || outside ? 0 : length;
}

/// Controls that no text needs, and marks by which a name would show in another order than it has.
bool misleads(std::string_view character)
{
    if (character.size() == 1) {
        const auto c = static_cast<unsigned char>(character[0]);
        return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
    }
    if (character.size() != 3) return false;
    const bool embedding = character >= "\u202a" && character <= "\u202e";
    const bool isolate = character >= "\u2066" && character <= "\u2069";
    return embedding || isolate || character == "\u200e" || character == "\u200f";
}

}  // namespace

std::string readable(std::string_view text)
{
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const auto character = text.substr(0, std::max<std::size_t>(length, 1));
        safe += length == 0 || misleads(character) ? replacement : character;
        text.remove_prefix(character.size());
    }
    return safe;
}

std::string escape(std::string_view text)
{
    std::string safe;
    for (const char c : readable(text)) switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                safe += c;
        }
    return safe;
}

std::string html_of_markup(std::string_view markup)
{
    std::string html;
    for (const Run& run : parse_markup(typeset(markup))) {
        const char* tag = run.level == Run::Level::subscript ? "sub" : "sup";
        if (run.level == Run::Level::base)
            html += escape(run.text);
        else
            html += std::string("<") + tag + ">" + escape(run.text) + "</" + tag + ">";
    }
    return html;
}

std::string json_string(std::string_view text)
{
    std::string json = "\"";
    for (const char c : readable(text)) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (code < 0x20 || c == '<' || c == '>' || c == '&') {
            char buffer[8];
            std::snprintf(buffer, sizeof buffer, "\\u%04x", code);
            json += buffer;
        } else {
            json += c;
        }
    }
    return json + '"';
}

std::string fill(std::string_view page, const std::map<std::string, std::string, std::less<>>& values)
{
    std::string result;
    for (;;) {
        const std::size_t open = page.find("{{"), close = page.find("}}", open);
        if (open == std::string_view::npos || close == std::string_view::npos) return result += page;
        const std::string_view name = page.substr(open + 2, close - open - 2);
        const auto value = values.find(name);
        if (value == values.end()) throw std::logic_error("the page asks for {{" + std::string(name) + "}}");
        result += page.substr(0, open);
        result += value->second;
        page.remove_prefix(close + 2);
    }
}

std::string policy_hash(std::string_view hexadecimal)
{
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2) {
        unsigned value = 0;
        std::from_chars(hexadecimal.data() + i, hexadecimal.data() + i + 2, value, 16);
        bytes += static_cast<char>(value);
    }
    return "sha256-" + base64(bytes);
}

}  // namespace stickslip::drawing
