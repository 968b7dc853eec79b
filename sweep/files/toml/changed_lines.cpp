#include "sweep/files/toml/changed_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <vector>

namespace stickslip {
namespace {

struct Entry {
    std::string table, key, value;  ///< "[friction.motor]", "coulomb", "2.1   # N"
};

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

std::vector<Entry> entries(std::string_view text)
{
    std::vector<Entry> list;
    std::string table;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto equals = line.find('=');
        if (line.starts_with('['))
            table = line;
        else if (equals != std::string_view::npos && !line.starts_with('#'))
            list.push_back({table, trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1))});
    }
    return list;
}

/// Nobody types, or knows, more digits of a measured number; other values as they are.
std::string typed(const std::string& value)
{
    double number = 0;
    const auto end = value.data() + value.size();
    if (const auto [read, error] = std::from_chars(value.data(), end, number); error != std::errc{} || read != end)
        return value;
    return fmt::format("{:.7g}", number);
}

/// The value without its comment, with as many digits as somebody would type.
std::string typed_value(const std::string& entry)
{
    return typed(trimmed(entry.substr(0, entry.find('#'))));
}

}  // namespace

std::string changed_lines(std::string_view before, std::string_view after)
{
    std::map<std::pair<std::string, std::string>, std::string> was;
    for (const auto& e : entries(before)) was[{e.table, e.key}] = e.value;
    std::string text, table;
    for (const auto& e : entries(after)) {
        const auto old = was.find({e.table, e.key});
        if (old != was.end() && typed_value(old->second) == typed_value(e.value)) continue;
        if (e.table != table) text += (text.empty() ? "" : "\n") + e.table + "\n";
        table = e.table;
        const std::string unit =
            e.value.find('#') == std::string::npos ? "" : trimmed(e.value.substr(e.value.find('#') + 1));
        text += e.key + " = " + typed_value(e.value) + "   #";
        if (!unit.empty()) text += " " + unit + ",";
        text += old == was.end() ? " not in the documented file\n" : " documented: " + typed_value(old->second) + "\n";
    }
    return text;
}

}  // namespace stickslip
