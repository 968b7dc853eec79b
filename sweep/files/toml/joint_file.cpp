#include "sweep/files/toml/joint_file.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/joint_table.h"
#include "sweep/files/toml/refused_memory.h"
#include "sweep/files/toml/servo.h"
#include "sweep/files/toml/struct_reader.h"

namespace stickslip {
namespace files {
namespace {

template <class Enum, int n>
void take(const toml::node_view<const toml::node>& node, const Choice<Enum> (&choices)[n], Enum& value)
{
    const auto name = node.value<std::string>();
    for (const auto& c : choices)
        if (name == c.name) value = c.value;
}

/// The drive is described behind the gains, whose units depend on it.
void take_drive(const toml::table& root, Actuator& actuator)
{
    take(root["actuator"]["kind"], actuator_kinds, actuator.kind);
    take(root["actuator"]["signal"], drive_signals, actuator.signal);
}

void read_into(Joint& joint, const toml::table& root, Complaints& complaints, Mode mode,
               const std::vector<std::string>& also_allowed, const std::filesystem::path& folder = {})
{
    const auto explain = [&joint](const std::string& path, const std::vector<std::string>& siblings) {
        return explain_unknown_key(joint, path, siblings);
    };
    take_drive(root, joint.actuator);
    StructReader reader(
        complaints, [&joint] { return units_of(joint); }, mode, explain, folder);
    if (mode == Mode::whole) {
        auto gains = servo_gains(root, complaints);
        reader.fill(std::move(gains.numbers), std::move(gains.choices), "control.servo");
        reader.allow({"control.servo", "control.registers"});
    }
    reader.read(root, "", joint, also_allowed);
}

/// The value of a setting as TOML understands it; what is no TOML value is text, so that names and units need no
/// quotes. Numbers need no digit on both sides of the point.
toml::table value_of(const std::string& text)
{
    try {
        toml::table parsed = toml::parse("value = " + text);
        if (parsed.size() == 1 && parsed.contains("value")) return parsed;
    } catch (const toml::parse_error&) {
        // not a TOML value: a name, a number with its unit, or a number as shells and languages write it
    }
    toml::table table;
    double number = 0;
    if (parse_cell(text, number) && is_set(number))
        table.insert("value", number);
    else
        table.insert("value", text);
    return table;
}

/// { a = { b = value } } for the path "a.b".
toml::table nested(std::string_view path, toml::table value)
{
    const auto dot = path.rfind('.');
    const std::string_view key = dot == std::string_view::npos ? path : path.substr(dot + 1);
    toml::table table;
    table.insert(key, std::move(*value.get("value")));
    if (dot == std::string_view::npos) return table;
    toml::table wrapped;
    wrapped.insert("value", std::move(table));
    return nested(path.substr(0, dot), std::move(wrapped));
}

}  // namespace

Joint joint_from(const toml::table& root, Complaints& complaints, const std::vector<std::string>& also_allowed,
                 const std::filesystem::path& folder)
{
    Joint joint;
    const std::size_t before = complaints.count();
    read_into(joint, root, complaints, Mode::whole, also_allowed, folder);
    if (complaints.count() > before) return joint;
    // the joint's own check is the last word: it may know rules that join several tables
    for (const auto& problem : check(joint)) complaints.add(Place(root.source()), problem.path, problem.message);
    return joint;
}

}  // namespace files

Joint read_joint(const std::filesystem::path& file)
{
    return read_joint_text(files::read_text(file), file.string(), file.parent_path());
}

namespace {

/// A sweep's spec has the joint inside it, or names its file.
void refuse_spec(const toml::table& root, files::Complaints& complaints)
{
    const toml::node* sign = root.get("axes");
    const auto* file = root.get("joint");
    const bool names_file = file && file->is_string();
    if (names_file) sign = file;
    if (!sign) return;
    complaints.add(sign->source(), names_file ? "joint" : "axes",
                   "this is the spec of a sweep, expected a joint file: " +
                       (names_file ? "the one that it names, " + file->value_or(std::string())
                                   : "stickslip new joint --from " + complaints.source() + " writes its design point"));
    complaints.throw_if_any();
}

}  // namespace

Joint read_joint_text(std::string_view text, const std::string& name, const std::filesystem::path& folder)
{
    const toml::table root = files::parse_toml(text, name);
    files::Complaints complaints(name);
    refuse_spec(root, complaints);
    Joint joint = files::joint_from(root, complaints, {"record", "requirements"}, folder);
    complaints.throw_if_any();
    return joint;
}

void apply_setting(Joint& joint, std::string_view setting)
{
    files::Complaints complaints("--set " + std::string(setting));
    const auto equals = setting.find('=');
    const std::string_view path = files::trimmed(setting.substr(0, equals));
    if (equals == std::string_view::npos || path.empty()) {
        complaints.add({}, "", "is not a setting, expected path=value such as control.k_p=2e4");
        complaints.throw_if_any();
    }
    const std::string value(files::trimmed(setting.substr(equals + 1)));
    Joint changed = joint;
    files::read_into(changed, files::nested(path, files::value_of(value)), complaints, files::Mode::change, {});
    complaints.throw_if_any();
    if (changed.pose.of && path.starts_with("pose")) changed.pose.of->apply(changed.pose.coordinates, changed);
    joint = changed;
}

void apply_settings(Joint& joint, const std::vector<std::string>& settings)
{
    Joint changed = joint;
    std::vector<std::string> messages;
    for (const auto& setting : settings) {
        try {
            apply_setting(changed, setting);
        } catch (const BadInput& bad) {
            messages.insert(messages.end(), bad.messages().begin(), bad.messages().end());
        }
    }
    if (messages.empty())
        if (const auto late = files::refused_memory(changed.control, changed.sensor.delay); !late.message.empty())
            messages.push_back("--set: " + late.path + ": " + late.message);
    if (messages.empty())
        for (const auto& problem : check(changed))
            messages.push_back("--set: " + problem.path + ": " + problem.message);
    if (!messages.empty()) throw BadInput(messages);
    joint = changed;
}

}  // namespace stickslip
