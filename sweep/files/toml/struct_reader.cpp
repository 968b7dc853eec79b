#include "sweep/files/toml/struct_reader.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/kernel_table_file.h"
#include "sweep/files/text/units.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stickslip::files {

std::string allowed_text(const Field& field, Units units)
{
    const std::string unit(unit_of(field.quantity, units));
    const std::string range = stickslip::describe(field.range);
    return (unit == "1" ? "a number, " : "a number in " + unit + ", ") + range;
}

std::string read_number(const toml::node& node, const Field& f, Units units, double& value)
{
    double given = 0;
    std::string written = describe(node);
    if (const auto number = node.value<double>(); number && node.is_number()) {
        given = *number;
    } else if (const auto* text = node.as_string()) {
        const auto reading = parse_number_with_unit(text->get(), f.quantity, units);
        if (!reading.error.empty()) return reading.error;
        given = reading.value;
        written += " (" + number_text(given) + " " + std::string(unit_of(f.quantity, units)) + ")";
    } else {
        return "is " + written + ", expected " + allowed_text(f, units);
    }
    const bool unlimited = given == infinity && value == infinity;
    if (!unlimited && !f.range.holds(given))
        return "is " + written + (std::isfinite(given) ? "" : ", which is not finite") + ", expected " +
               allowed_text(f, units);
    value = given;
    return "";
}

const toml::node* StructReader::find(std::string_view key)
{
    frame_.known.emplace_back(key);
    return frame_.table->get(key);
}

void StructReader::complain(const toml::node& node, std::string_view key, const std::string& text)
{
    complaints_.add(Place(node.source()).or_else(frame_.place), path(key), text);
}

void StructReader::complain_missing(std::string_view key, const std::string& text)
{
    complaints_.add(frame_.place, path(key), "is missing, " + text);
}

void StructReader::complain_filled(const toml::node& node, std::string_view key)
{
    complain(node, key, "is stated, and " + filled_by_ + " says it, too: expected one of them");
}

void StructReader::complain_unknown()
{
    if (frame_.uncertain) return;
    for (auto&& [key, node] : *frame_.table) {
        const std::string name(key.str());
        if (std::find(frame_.known.begin(), frame_.known.end(), name) != frame_.known.end()) continue;
        if (std::find(read_elsewhere_.begin(), read_elsewhere_.end(), path(name)) != read_elsewhere_.end()) continue;
        const Place place = Place(key.source()).or_else(frame_.place);
        complaints_.add(place, path(name), explain_(path(name), frame_.known));
    }
}

int StructReader::index_of(const toml::node& node, std::string_view key, const std::vector<std::string>& names)
{
    const auto* text = node.as_string();
    if (text) {
        const auto found = std::find(names.begin(), names.end(), text->get());
        if (found != names.end()) return static_cast<int>(found - names.begin());
    }
    complain(node, key,
             "is " + describe(node) + ", expected " + listed(names) + (text ? did_you_mean(text->get(), names) : ""));
    return -1;
}

bool StructReader::take_number(const toml::node& node, std::string_view key, const Field& f, double& value)
{
    const std::string problem = read_number(node, f, units_(), value);
    if (!problem.empty()) complain(node, key, problem);
    return problem.empty();
}

void StructReader::number(const Field& f, double& value)
{
    const toml::node* node = find(f.key);
    if (const auto filled = numbers_.find(path(f.key)); filled != numbers_.end()) {
        if (node) complain_filled(*node, f.key);
        value = filled->second;
    } else if (node) {
        take_number(*node, f.key, f, value);
    } else if (f.need == Need::required && mode_ == Mode::whole && !frame_.uncertain) {
        complain_missing(f.key, "expected " + allowed_text(f, units_()) + ": " + std::string(f.help));
    }
}

void StructReader::numbers(const Field& f, NumberList& list)
{
    const toml::node* node = find(f.key);
    if (!node) {
        if (f.need == Need::required && mode_ == Mode::whole && !frame_.uncertain)
            complain_missing(f.key,
                             "expected " + allowed_text(f, units_()) + ", or a list of them: " + std::string(f.help));
        return;
    }
    if (const auto* indexed = indexed_table(*node)) {
        for (auto&& [index, element] : *indexed) {
            const int i = row_index(index, f.key, list.size);
            if (i >= 0) take_number(element, f.key, f, list[i]);
        }
        return;
    }
    const auto* array = node->as_array();
    NumberList read;
    if (!array) {
        if (take_number(*node, f.key, f, read[0])) {
            read.size = 1;
            list = read;
        }
        return;
    }
    if (array->empty() || array->size() > static_cast<std::size_t>(NumberList::max_size)) {
        complain(*node, f.key,
                 "is a list of " + std::to_string(array->size()) + ", expected 1 to " +
                     std::to_string(NumberList::max_size) + " values");
        return;
    }
    bool sound = true;
    for (const auto& element : *array) {
        double value = 0;
        sound = take_number(element, std::string(f.key) + "." + std::to_string(read.size), f, value) && sound;
        read.push_back(value);
    }
    if (sound) list = read;
}

void StructReader::flag(std::string_view key, std::string_view, bool& value)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (const auto* given = node->as_boolean())
        value = given->get();
    else
        complain(*node, key, "is " + describe(*node) + ", expected true, false");
}

void StructReader::text(std::string_view key, std::string_view, std::string& value)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (const auto* given = node->as_string())
        value = given->get();
    else
        complain(*node, key, "is " + describe(*node) + ", expected text in quotes");
}

void StructReader::samples(std::string_view key, std::string_view help, std::string& name, KernelTablePtr& table)
{
    text(key, help, name);
    const toml::node* node = frame_.table->get(key);
    if (!node || !node->is_string()) return;
    try {
        table =
            name.empty() ? nullptr : std::make_shared<const KernelTable>(read_kernel_table(folder_ / name, units_()));
    } catch (const BadInput& bad) {
        for (const auto& message : bad.messages()) complain(*node, key, "is \"" + name + "\": " + message);
    }
}

const toml::table* StructReader::indexed_table(const toml::node& node) const
{
    const auto* table = node.as_table();
    if (mode_ != Mode::change || !table || table->empty()) return nullptr;
    for (auto&& [key, value] : *table)
        if (key.str().find_first_not_of("0123456789") != std::string_view::npos) return nullptr;
    return table;
}

int StructReader::row_index(const toml::key& index, std::string_view key, int size)
{
    const std::string_view digits = index.str();
    int i = -1;
    std::from_chars(digits.data(), digits.data() + digits.size(), i);
    if (i >= 0 && i < size) return i;
    complaints_.add(frame_.place, path(key) + "." + std::string(digits),
                    "there is no such element; the list has " + std::to_string(size) + ", counted from 0");
    return -1;
}

std::vector<const toml::table*> StructReader::tables_of(const toml::node& node, std::string_view key, int capacity)
{
    std::vector<const toml::table*> tables;
    if (const auto* single = node.as_table()) return {single};
    const auto* array = node.as_array();
    if (!array || array->empty() || array->size() > static_cast<std::size_t>(capacity)) {
        const std::string given = array ? "a list of " + std::to_string(array->size()) : describe(node);
        complain(node, key, "is " + given + ", expected a list of 1 to " + std::to_string(capacity) + " tables");
        return {};
    }
    for (const auto& element : *array) {
        if (const auto* table = element.as_table())
            tables.push_back(table);
        else
            complain(element, key, "is " + describe(element) + ", expected a table");
    }
    return tables;
}

}  // namespace stickslip::files
