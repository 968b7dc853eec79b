// stickslip import: one joint of a robot's description as joint.toml.
#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/import_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/robot_table.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/words/robot_description_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string robot, joint, pose, file;
    std::vector<std::string> settings;
    bool json = false;
};

nlohmann::ordered_json finite(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string_view word(NotTakenReason reason)
{
    for (const auto& choice : not_taken_reasons)
        if (choice.value == reason) return choice.name;
    return "";
}

nlohmann::ordered_json not_taken_json(const std::vector<NotTaken>& elements)
{
    auto list = nlohmann::ordered_json::array();
    for (const auto& of : elements)
        list.push_back({{"place", of.place},
                        {"element", of.element},
                        {"name", of.name},
                        {"attributes", of.attributes},
                        {"reason", word(of.reason)}});
    return list;
}

/// Of the joint at its side of the gear, whatever stands in its way.
double effort_limit(const RobotJoint& j)
{
    double limit = std::min({j.effort, j.servo.effort_limit, j.motor.effort_limit});
    if (is_set(j.motor.effort_per_command))
        limit = std::min(limit, std::abs(j.motor.effort_per_command) * j.motor.command_limit);
    return limit;
}

nlohmann::ordered_json import_json(const ImportAnswer& answer, const std::string& text)
{
    const auto& d = answer.dynamics;
    const auto& j = answer.described;
    auto impossible = nlohmann::ordered_json::array();
    for (const auto& of : answer.impossible)
        impossible.push_back(
            {{"body", of.body}, {"place", of.place}, {"moments", {of.moments[0], of.moments[1], of.moments[2]}}});
    auto suspected = nlohmann::ordered_json::array();
    for (const auto& of : answer.suspected) {
        const bool length = of.kind == SuspectedUnit::Kind::length;
        suspected.push_back({{"kind", length ? "length" : "angle"},
                             {"of", of.of},
                             {"place", of.place},
                             {"value", of.value},
                             {"unit", length ? "m" : "rad"}});
    }
    auto beyond = nlohmann::ordered_json::array();
    for (const auto& of : answer.beyond)
        beyond.push_back({{"joint", of.joint.name},
                          {"position", of.position},
                          {"lower", finite(of.joint.low)},
                          {"upper", finite(of.joint.high)},
                          {"place", of.joint.place}});
    return {{"format", "stickslip-import/1"},
            {"joint", j.name},
            {"text", text},
            {"position", answer.position},
            {"inertia", d.inertia},
            {"armature", j.armature},
            {"moved_mass", d.mass},
            {"gravity",
             {{"amplitude", d.gravity_amplitude},
              {"phase", d.gravity_phase},
              {"effort", d.gravity_effort},
              {"stiffness", d.gravity_stiffness}}},
            {"friction", {{"coulomb", j.friction}, {"viscous", j.damping}}},
            {"limits",
             {{"lower", finite(j.low)},
              {"upper", finite(j.high)},
              {"velocity", finite(j.velocity)},
              {"effort", finite(effort_limit(j))}}},
            {"gear", j.gear},
            {"impossible_inertias", impossible},
            {"suspected_units", suspected},
            {"beyond_limits", beyond},
            {"not_taken", not_taken_json(answer.not_taken)},
            {"missing", answer.missing}};
}

int import_verb(const Options& options)
{
    const Robot robot = read_robot(options.robot);
    const auto pose = read_pose(robot, options.pose);
    auto answer = import_joint(robot, joint_named(robot, options.joint, options.robot), pose);
    if (answer.loop)
        throw BadInput(answer.loop->place + ": " + answer.loop->what + " closes a loop through joint \"" +
                       options.joint + "\"; expected a joint that moves freely while all others stand still");
    for (const auto& setting : options.settings) apply_setting(answer.joint, setting);
    std::erase_if(answer.missing, [&](const std::string& path) {
        return std::any_of(options.settings.begin(), options.settings.end(),
                           [&](const std::string& s) { return s.starts_with(path + "="); });
    });
    const auto text = import_text(answer, options.robot, options.pose);
    if (options.json) fmt::print("{}\n", import_json(answer, text).dump(2));
    if (options.json && options.file.empty()) return exit_done;
    if (options.file.empty()) {
        fmt::print("{}", text);
    } else {
        write_whole(options.file, text);
    }
    for (const auto& of : answer.impossible) say("note: {}\n", impossible_inertia_text(of));
    for (const auto& of : answer.suspected) say("note: {}\n", suspected_unit_text(of));
    for (const auto& of : answer.not_taken) say("note: {}\n", not_taken_text(of));
    for (const auto& of : answer.beyond) say("note: {}\n", beyond_limits_text(of));
    for (const auto& path : answer.missing) say("Still to fill in: {} (or --set {}=…)\n", path, path);
    return exit_done;
}

}  // namespace

void add_import(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("import", "Make joint.toml of one joint of a robot: URDF or MJCF");
    verb.add_option("ROBOT", options->robot, "robot description, URDF or MJCF")->required();
    verb.add_option("--joint", options->joint, "name of the joint")->required();
    verb.add_option("--at", options->pose, "pose: TOML with joint = coordinate, rad or m; other joints are at zero");
    verb.add_option("--set", options->settings, "set a parameter: path=value");
    verb.add_option("-o,--output", options->file, "file to write; default: standard output");
    verb.add_flag("--json", options->json, "machine-readable, stable names");
    verb.footer(
        "Example: stickslip import robot.urdf --joint elbow --at pose.toml --set control.k_p=200 -o joint.toml");
    verb.callback([options, &invocation] { invocation.exit_code = import_verb(*options); });
}

}  // namespace stickslip
