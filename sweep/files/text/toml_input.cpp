#include "sweep/files/text/toml_input.h"

#include "sweep/files/text/bad_input.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iostream>
#include <map>
#include <tuple>

namespace stickslip::files {
namespace {

constexpr std::uintmax_t max_bytes = 16u << 20;  // a description is a page of text; this is a wrong file
constexpr std::size_t max_quoted = 60;           // characters of a text that a message repeats

std::string below(const std::string& path, const std::string& key)
{
    return path.empty() ? key : path + "." + key;
}

std::string at(const std::string& source, const Place& place)
{
    if (place.line == 0) return source;
    return source + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

std::string_view from_line(std::string_view text, unsigned number)
{
    for (; number > 1 && !text.empty(); --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text;
}

/// Where this text ceases to be TOML; 0 where it does not.
unsigned first_bad_line(std::string_view text)
{
    try {
        (void)toml::parse(text);
        return 0;
    } catch (const toml::parse_error& error) {
        return error.source().begin.line;
    }
}

/// A statement that is valid by itself, below lines that are: what it names was given above.
bool given_above(std::string_view text, unsigned line)
{
    const auto here = from_line(text, line);
    return first_bad_line(text.substr(0, text.size() - here.size())) == 0 && first_bad_line(here) != 1;
}

/// `key = 1 mm/s`: a number and a unit behind it, without quotes.
bool number_with_unit(std::string_view line)
{
    line.remove_prefix(std::min(line.find('='), line.size()));
    line.remove_prefix(std::min(line.find_first_not_of("= \t"), line.size()));
    double number = 0;
    const auto end = std::from_chars(line.data(), line.data() + line.size(), number);
    if (end.ec != std::errc()) return false;
    line.remove_prefix(static_cast<std::size_t>(end.ptr - line.data()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const auto first = line.empty() ? '\0' : line.front();
    return std::isalpha(static_cast<unsigned char>(first)) || first == '%' || first < 0;  // "°" and "µ" are no ASCII
}

/// toml++ says what its parser was doing; a writer wants to know what is wrong with the line.
std::string syntax_error(std::string_view parser_says, std::string_view text, unsigned number)
{
    auto line = from_line(text, number);
    line = line.substr(0, std::min(line.find('\n'), line.find('\r')));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (given_above(text, number)) {
        const auto name =
            line.starts_with('[') ? line : line.substr(0, line.find_last_not_of(" \t", line.find('=') - 1) + 1);
        return std::string(name) + " appears twice in this file; keep one of the two";
    }
    if (parser_says.starts_with("Error while parsing "))
        parser_says.remove_prefix(std::min(parser_says.find(": "), parser_says.size() - 2) + 2);
    return "not valid TOML: " + std::string(parser_says) +
           (number_with_unit(line) ? "; a number with a unit is written in quotes, as in V0 = \"1 mm/s\"" : "");
}

}  // namespace

void Complaints::add(const Place& place, std::string_view path, std::string_view text)
{
    std::string message = at(source_, place) + ": ";
    if (!path.empty()) message += std::string(path) + ": ";
    entries_.push_back({place, message + std::string(text)});
}

void Complaints::add_foreign(const std::vector<std::string>& messages)
{
    foreign_.insert(foreign_.end(), messages.begin(), messages.end());
}

std::vector<std::string> Complaints::messages() const
{
    std::vector<Entry> sorted = entries_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    std::vector<std::string> texts = foreign_;
    for (auto& entry : sorted) texts.push_back(std::move(entry.text));
    return texts;
}

void Complaints::throw_if_any() const
{
    if (!empty()) throw BadInput(messages());
}

namespace {

/// Standard input, which can be read once, for every question about the same file.
const std::string& standard_input()
{
    static const std::string text = [] {
        std::string all(max_bytes + 1, '\0');
        std::cin.read(all.data(), static_cast<std::streamsize>(all.size()));
        all.resize(static_cast<std::size_t>(std::cin.gcount()));
        return all;
    }();
    return text;
}

/// Text as Windows programs save it under the name Unicode.
void refuse_utf16(std::string_view text, const std::string& name)
{
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw BadInput(name + ": is written in UTF-16, expected UTF-8; save it again with that encoding");
}

}  // namespace

std::string read_text(const std::filesystem::path& file)
{
    if (file == "-" || file == "/dev/stdin") {
        const auto& text = standard_input();
        if (text.size() > max_bytes) throw BadInput("standard input: is larger than 16 MiB, expected a TOML file");
        refuse_utf16(text, "standard input");
        return text;
    }
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw BadInput(file.string() + ": there is no such file");
    if (std::filesystem::is_directory(file, error))
        throw BadInput(file.string() + ": is a folder, expected a TOML file");
    // a pipe can be read once, and a joint file is read again for the places of its keys
    static std::map<std::filesystem::path, std::string> pipes;
    const bool pipe = !std::filesystem::is_regular_file(file, error);
    if (const auto known = pipes.find(file); pipe && known != pipes.end()) return known->second;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw BadInput(file.string() + ": cannot be opened for reading");
    std::string text;
    for (char block[1 << 16]; text.size() <= max_bytes && stream;) {
        stream.read(block, sizeof block);
        text.append(block, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) throw BadInput(file.string() + ": cannot be read");
    if (text.size() > max_bytes) throw BadInput(file.string() + ": is larger than 16 MiB, expected a TOML file");
    refuse_utf16(text, file.string());
    if (pipe) pipes[file] = text;
    return text;
}

toml::table parse_toml(std::string_view text, const std::string& name)
{
    try {
        return toml::parse(text, std::string_view(name));
    } catch (const toml::parse_error& error) {
        Complaints complaints(name);
        const Place place(error.source());
        complaints.add(place, "", syntax_error(error.description(), text, place.line));
        throw BadInput(complaints.messages());
    }
}

std::string describe(const toml::node& node)
{
    if (const auto* text = node.as_string()) {
        const std::string& value = text->get();
        return "\"" + (value.size() > max_quoted ? value.substr(0, max_quoted) + "…" : value) + "\"";
    }
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* real = node.as_floating_point()) return number_text(real->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (node.is_array()) return "a list";
    if (node.is_table()) return "a table";
    return "a date or time";
}

const toml::table* table_at(const toml::table& parent, const std::string& key, const std::string& path,
                            Complaints& complaints)
{
    const auto* node = parent.get(key);
    if (node && !node->is_table())
        complaints.add(Place(node->source()), below(path, key), "is " + describe(*node) + ", expected a table");
    return node ? node->as_table() : nullptr;
}

void read_text_at(const toml::table& parent, const std::string& key, const std::string& path, std::string& value,
                  Complaints& complaints)
{
    const auto* node = parent.get(key);
    if (!node) return;
    if (const auto* text = node->as_string())
        value = text->get();
    else
        complaints.add(Place(node->source()), below(path, key), "is " + describe(*node) + ", expected text in quotes");
}

void complain_unknown_keys(const toml::table& table, const std::vector<std::string>& allowed, const std::string& path,
                           Complaints& complaints)
{
    for (auto&& [key, node] : table) {
        const std::string name(key.str());
        if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
        const Place place = Place(key.source()).or_else(Place(table.source()));
        complaints.add(place, below(path, name),
                       "unknown key, expected " + listed(allowed) + did_you_mean(name, allowed));
    }
}

std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table)
{
    std::vector<std::tuple<unsigned, unsigned, std::string, const toml::node*>> keyed;
    for (auto&& [key, node] : table) {
        const Place place(key.source());
        keyed.emplace_back(place.line, place.column, std::string(key.str()), &node);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::pair<std::string, const toml::node*>> ordered;
    for (auto& [line, column, key, node] : keyed) ordered.emplace_back(std::move(key), node);
    return ordered;
}

}  // namespace stickslip::files
