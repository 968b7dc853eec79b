#include "render/page/html.h"

#include "render/drawing/encode.h"
#include "render/drawing/markup.h"

#include <charconv>
#include <cstdio>
#include <stdexcept>

namespace stickslip::drawing {

std::string escape(std::string_view text)
{
    std::string safe;
    for (const char c : text) switch (c) {
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
    for (const Run& run : parse_markup(markup)) {
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
    for (const char c : text) {
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
