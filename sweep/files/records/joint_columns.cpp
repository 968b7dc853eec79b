#include "sweep/files/records/joint_columns.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/header_row.h"

#include <algorithm>
#include <optional>

namespace stickslip {
namespace {

/// A column that says whose it is.
struct Named {
    std::string joint;
    const Signal* signal = nullptr;
};

/// "elbow_position", "position/elbow", "position[elbow]". Of two signals that would do the longer: the joint of
/// elbow_reference_position is elbow.
std::optional<Named> named_column(const std::string& name)
{
    constexpr std::string_view joiners = "_./:-";
    std::optional<Named> best;
    for (const auto& signal : signals()) {
        const std::string own(signal.name);
        if (name.size() < own.size() + 2) continue;
        std::string joint;
        if (name.ends_with(own) && joiners.find(name[name.size() - own.size() - 1]) != joiners.npos)
            joint = name.substr(0, name.size() - own.size() - 1);
        else if (name.starts_with(own) && joiners.find(name[own.size()]) != joiners.npos)
            joint = name.substr(own.size() + 1);
        else if (name.starts_with(own + "[") && name.ends_with("]"))
            joint = name.substr(own.size() + 1, name.size() - own.size() - 2);
        if (!joint.empty() && (!best || own.size() > best->signal->name.size())) best = Named{joint, &signal};
    }
    return best;
}

/// What is the same for every joint of a machine.
bool shared(const Signal& signal)
{
    for (const char* name : {"time", "supply_voltage", "temperature", "torque_enable"})
        if (signal.name == name) return true;
    return false;
}

std::vector<std::string> names_in(const std::filesystem::path& table)
{
    files::LineStream lines(table);
    std::string_view line;
    if (!files::next_header(lines, line))
        throw BadInput(table.string() + ": is empty, expected a header row such as time,elbow_position");
    return files::header_names(line, files::separator_of(line));
}

template <class List>
bool holds(const List& list, const std::string& name)
{
    return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

std::vector<std::string> joints_named_in(const std::vector<std::string>& columns)
{
    std::vector<std::string> joints;
    for (const auto& name : columns) {
        const auto named = signal_named(name) ? std::nullopt : named_column(name);
        if (named && !holds(joints, named->joint)) joints.push_back(named->joint);
    }
    return joints;
}

RecordLayout layout_for_joint(RecordLayout layout, const std::string& joint)
{
    const std::string place = "{joint}";
    for (auto& rule : layout.rules)
        for (auto& column : rule.columns)
            for (auto at = column.name.find(place); at != std::string::npos; at = column.name.find(place, at))
                column.name.replace(at, place.size(), joint), at += joint.size();
    return layout;
}

JointColumns joint_columns(const std::filesystem::path& table, const std::string& joint, RecordLayout layout)
{
    JointColumns found;
    const auto names = names_in(table);
    found.joints = joints_named_in(names);
    const auto stated = layout.rule_for(table.filename().string()).columns;
    RecordLayout::Rule own;
    std::vector<std::string> taken;
    for (const auto& column : stated) {
        const Signal* signal = signal_named(column.signal);
        found.present = found.present || (signal && signal->measured && holds(names, column.name));
        taken.push_back(column.name);
    }
    const auto is_stated = [&](std::string_view signal) {
        return std::any_of(stated.begin(), stated.end(), [&](const auto& column) { return column.signal == signal; });
    };
    for (const auto& name : names) {
        const Signal* plain = signal_named(name);
        const auto named = plain ? std::nullopt : named_column(name);
        if (holds(taken, name)) continue;
        if (named && named->joint == joint && !is_stated(named->signal->name)) {
            found.present = found.present || named->signal->measured;
            own.columns.push_back({std::string(named->signal->name), name, {}, table.string() + ":1:1"});
        } else if (!plain || !shared(*plain)) {
            own.others.push_back(name);
        }
    }
    found.layout = std::move(layout);
    found.layout.rules.push_back(std::move(own));
    return found;
}

}  // namespace stickslip
