#include "sweep/files/records/record_layout.h"

#include "sweep/files/text/units.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/named_values.h"
#include "sweep/files/toml/struct_reader.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

namespace stickslip {

RecordLayout::Rule RecordLayout::rule_for(const std::string& file_name) const
{
    Rule all;
    const auto put = [](auto& list, const auto& entry, auto key) {
        const auto same = std::find_if(list.begin(), list.end(), [&](const auto& e) { return key(e) == key(entry); });
        if (same == list.end())
            list.push_back(entry);
        else
            *same = entry;
    };
    const auto first = [](const auto& pair) { return pair.first; };
    for (const auto& rule : rules) {
        if (fnmatch(rule.pattern.c_str(), file_name.c_str(), 0) != 0) continue;
        for (const auto& column : rule.columns) put(all.columns, column, [](const Column& c) { return c.signal; });
        for (const auto& constant : rule.constants) put(all.constants, constant, first);
        for (const auto& change : rule.overrides) put(all.overrides, change, first);
        all.others.insert(all.others.end(), rule.others.begin(), rule.others.end());
        if (rule.at_rest_at_start) all.at_rest_at_start = rule.at_rest_at_start;
    }
    return all;
}

namespace files {
namespace {

const std::vector<std::string> rule_keys{"columns", "constants", "at_rest_at_start"};
const std::vector<std::string> top_keys = names_of(record_keys, "record");
const std::vector<std::string> column_keys = names_of(record_column_keys, "record.columns.SIGNAL");

class LayoutReader {
  public:
    LayoutReader(const Joint& joint, Complaints& complaints)
        : joint_(joint), units_(joint.mechanism.motion), complaints_(complaints)
    {
        for (const auto& s : signals()) names_.emplace_back(s.name);
    }

    RecordLayout read(const toml::table& table)
    {
        RecordLayout layout;
        layout.rules.push_back(rule(table, "*", "record", false));
        if (const auto* files = table_at(table, "files", "record", complaints_)) {
            for (const auto& [pattern, node] : in_file_order(*files)) {
                const std::string path = "record.files." + pattern;
                if (const auto* inner = node->as_table())
                    layout.rules.push_back(rule(*inner, pattern, path, true));
                else
                    complaints_.add(Place(node->source()), path, "is " + describe(*node) + ", expected a table");
            }
        }
        return layout;
    }

  private:
    RecordLayout::Rule rule(const toml::table& table, const std::string& pattern, const std::string& path,
                            bool per_file)
    {
        RecordLayout::Rule rule;
        rule.pattern = pattern;
        if (!per_file) complain_unknown_keys(table, top_keys, path, complaints_);
        if (const auto* columns = table_at(table, "columns", path, complaints_))
            read_columns(*columns, path + ".columns", rule);
        if (const auto* constants = table_at(table, "constants", path, complaints_))
            read_constants(*constants, path + ".constants", rule);
        if (const auto* node = table.get("at_rest_at_start")) {
            if (const auto* flag = node->as_boolean())
                rule.at_rest_at_start = flag->get();
            else
                complaints_.add(Place(node->source()), path + ".at_rest_at_start",
                                "is " + describe(*node) + ", expected true, false");
        }
        // under a file pattern, whatever else stands there is a number of the joint
        if (per_file)
            for (const auto& change : dotted_values(table, {}, rule_keys)) read_override(change, path, rule);
        return rule;
    }

    const Signal* known_signal(const std::string& name, const Place& place, const std::string& path)
    {
        const Signal* signal = signal_named(name);
        if (!signal)
            complaints_.add(place, path + "." + name,
                            "is not a signal of a record, expected " + listed(names_) + did_you_mean(name, names_));
        return signal;
    }

    /// Whether the column of the file was written first and the signal behind it.
    bool turned_round(const std::string& name, const toml::node& node, const std::string& path)
    {
        const auto* text = node.as_string();
        if (!text || signal_named(name) || !signal_named(text->get())) return false;
        complaints_.add(
            Place(node.source()), path + "." + name,
            "is not a signal of a record, " + text->get() + " is: expected " + text->get() + " = \"" + name + "\"");
        return true;
    }

    void read_columns(const toml::table& table, const std::string& path, RecordLayout::Rule& rule)
    {
        for (auto&& [key, node] : table) {
            const std::string name(key.str());
            if (turned_round(name, node, path)) continue;
            const Signal* signal = known_signal(name, Place(key.source()), path);
            if (!signal) continue;
            const Place place(key.source());
            RecordLayout::Column column{
                name,
                "",
                {},
                complaints_.source() + ":" + std::to_string(place.line) + ":" + std::to_string(place.column)};
            if (const auto* text = node.as_string())
                column.name = text->get();
            else if (const auto* options = node.as_table())
                read_column(*options, place, path + "." + name, *signal, column);
            else
                complaints_.add(
                    Place(node.source()), path + "." + name,
                    "is " + describe(node) + ", expected the name of a column or { name, unit, scale, offset }");
            rule.columns.push_back(std::move(column));
        }
    }

    void read_column(const toml::table& table, const Place& place, const std::string& path, const Signal& signal,
                     RecordLayout::Column& column)
    {
        complain_unknown_keys(table, column_keys, path, complaints_);
        column.name = column.signal;  // an own name may come with a foreign unit
        std::string unit;
        read_text_at(table, "name", path, column.name, complaints_);
        read_text_at(table, "unit", path, unit, complaints_);
        double scale = 1, offset = 0;
        number(table, "scale", path, {"scale", Quantity::number}, scale);
        number(table, "offset", path, {"offset", signal.quantity}, offset);
        if (scale == 0)
            complaints_.add(Place(table.get("scale")->source()), path + ".scale",
                            "is 0, which says nothing about the signal");
        Unit conversion;
        column.unit_named = !unit.empty();
        if (!unit.empty()) {
            const UnitReading reading = signal.any_unit ? parse_unit(unit) : unit_for(unit, signal.quantity, units_);
            if (!reading.error.empty())
                complaints_.add(Place(table.get("unit")->source()).or_else(place), path + ".unit", reading.error);
            conversion = reading.unit;
        }
        column.scaling = scaling_of(conversion, scale, offset);
    }

    void read_constants(const toml::table& table, const std::string& path, RecordLayout::Rule& rule)
    {
        for (auto&& [key, node] : table) {
            const std::string name(key.str());
            const Signal* signal = known_signal(name, Place(key.source()), path);
            if (!signal) continue;
            double value = 0;
            const std::string problem =
                name == "time" ? "cannot be constant" : read_number(node, {name, signal->quantity}, units_, value);
            if (problem.empty())
                rule.constants.emplace_back(name, value);
            else
                complaints_.add(Place(node.source()), path + "." + name, problem);
        }
    }

    void read_override(const NamedValue& change, const std::string& path, RecordLayout::Rule& rule)
    {
        std::string name = change.path;
        if (!find_parameter(joint_, name) && name.find('.') == std::string::npos) {
            std::vector<std::string> ending;  // a bare key will do where only one number of the joint has it
            for (const auto& p : numeric_paths(joint_))
                if (p.ends_with("." + name)) ending.push_back(p);
            if (ending.size() == 1) name = ending.front();
        }
        const auto leaf = find_leaf(joint_, name, change.place, path, complaints_);
        if (!leaf) return;
        if (const auto value = read_value(*change.node, *leaf, units_, change.place, path + "." + name, complaints_))
            rule.overrides.emplace_back(name, *value);
    }

    void number(const toml::table& table, const std::string& key, const std::string& path, const Field& field,
                double& value)
    {
        const auto* node = table.get(key);
        if (!node) return;
        const std::string problem = read_number(*node, field, units_, value);
        if (!problem.empty()) complaints_.add(Place(node->source()), path + "." + key, problem);
    }

    Joint joint_;
    Units units_;
    Complaints& complaints_;
    std::vector<std::string> names_;
};

}  // namespace
}  // namespace files

RecordLayout read_record_layout_text(std::string_view text, const std::string& name, const Joint& joint)
{
    const toml::table root = files::parse_toml(text, name);
    files::Complaints complaints(name);
    RecordLayout layout;
    const auto* record = root.get("record");
    const bool joint_file =
        root.contains("joint") || root.contains("control") || root.contains("friction") || root.contains("joints");
    if (record && !record->is_table())
        complaints.add(files::Place(record->source()), "record",
                       "is " + files::describe(*record) + ", expected a table");
    else if (record)
        layout = files::LayoutReader(joint, complaints).read(*record->as_table());
    else if (!joint_file)
        layout = files::LayoutReader(joint, complaints).read(root);
    complaints.throw_if_any();
    return layout;
}

RecordLayout read_record_layout(const std::filesystem::path& file, const Joint& joint)
{
    return read_record_layout_text(files::read_text(file), file.string(), joint);
}

RecordLayout record_layout_for(const std::filesystem::path& record, const std::filesystem::path& joint_file,
                               const Joint& joint)
{
    RecordLayout layout = read_record_layout(joint_file, joint);
    const std::filesystem::path sidecar = record.parent_path() / "record.toml";
    std::error_code error;
    if (!std::filesystem::exists(sidecar, error)) return layout;
    for (auto& rule : read_record_layout(sidecar, joint).rules) layout.rules.push_back(std::move(rule));
    return layout;
}

}  // namespace stickslip
