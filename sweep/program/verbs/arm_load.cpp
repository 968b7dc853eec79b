// stickslip arm-load: columns of a moving arm's load and inertia for the records of its joints.
#include "sweep/study/import/arm_load.h"
#include "analysis/results/point.h"
#include "sweep/files/records/table_columns.h"
#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/series_file.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/robot_table.h"
#include "sweep/program/verbs/diagnosis_verbs.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/number_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stickslip {
namespace {

constexpr std::string_view ending = "_position";

struct Options {
    std::string table, robot, pose, file;
    std::vector<std::string> armature;
    double window = missing;  ///< s; not set: default_window of the rows
};

/// A joint that turns or stops is smeared over the window, noise grows as its −2.5th power. Evidence, weak: of three
/// arms without a cause (tests/python/test_arm.py, seeds 5, 101, 105; 500 Hz, 30 µrad of noise) 22, 30 and 40 ms leave
/// about the same, 1.07 to 1.08 × the noise floor in the mean, 50 ms 1.10, 80 and 120 ms more. Slower logs need the
/// rows of a cubic.
double default_window(const std::vector<double>& time)
{
    constexpr double usual = 0.03, longest = 0.1;  // s
    constexpr double rows = 6;
    if (time.size() < 2) return usual;
    const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    return std::clamp(rows * step, usual, longest);
}

/// Of one joint of the table.
struct Moved {
    std::string name;
    JointMotion motion, again;  ///< as it was measured, and as if it were measured again
    int index = -1;             ///< in the robot
    double armature = 0;        ///< of the description, and what was added
};

std::vector<std::string> joints_of(const std::string& file)
{
    std::vector<std::string> joints;
    for (const auto& name : table_columns(file))
        if (name.size() > ending.size() && name.ends_with(ending) && !name.ends_with("_reference_position") &&
            !name.ends_with("_link_position"))
            joints.push_back(name.substr(0, name.size() - ending.size()));
    if (joints.empty())
        throw BadInput(file + ": has no column of a joint's positions, expected columns such as elbow_position");
    return joints;
}

double armature_from(const std::string& setting, std::string& name)
{
    const auto equals = setting.find('=');
    char* end = nullptr;
    const std::string number = equals == setting.npos ? "" : setting.substr(equals + 1);
    const double value = std::strtod(number.c_str(), &end);
    if (number.empty() || *end || !(value >= 0) || !std::isfinite(value))
        throw BadInput("--armature: got \"" + setting + "\", expected JOINT=INERTIA with an inertia of 0 or more");
    name = setting.substr(0, equals);
    return value;
}

/// Smoothed motions of all joints of the table, and their times.
std::vector<Moved> motions_of(const Options& options, std::vector<double>& time)
{
    std::vector<Moved> all;
    for (const auto& name : joints_of(options.table)) {
        const auto column = name + std::string(ending);
        const auto series =
            read_series(options.table, column, SeriesQuantity{Quantity::number, Units(Motion::revolute)});
        time = series.time;
        const double window = is_set(options.window) ? options.window : default_window(time);
        try {
            auto motion = smoothed(series.time, series.value, window);
            auto again = measured_again(series.time, series.value, motion, window, all.size() + 1);
            all.push_back({name, std::move(motion), std::move(again)});
        } catch (const std::invalid_argument& e) {
            throw BadInput(options.table + ": " + column + ": " + e.what());
        }
    }
    return all;
}

void find_in_robot(const Robot& robot, const Options& options, std::vector<Moved>& all)
{
    for (auto& joint : all) {
        joint.index = joint_named(robot, joint.name, options.robot);
        const auto& described = robot.joints[static_cast<std::size_t>(joint.index)];
        if (described.kind == RobotJointKind::fixed)
            throw BadInput(described.place + ": joint " + joint.name + " is fixed, but the table has positions of it");
        for (const auto& closure : robot.closures)
            if (passes_through(robot, closure, joint.index))
                throw BadInput(closure.place + ": " + closure.what + " closes a loop through joint " + joint.name +
                               "; expected a robot whose joints move freely");
        joint.armature = described.armature;
    }
    for (const auto& setting : options.armature) {
        std::string name;
        const double value = armature_from(setting, name);
        bool known = false;
        for (auto& joint : all)
            if (joint.name == name) joint.armature += value, known = true;
        if (!known) throw BadInput("--armature: the table has no joint " + name);
    }
}

std::string table_of(const std::vector<double>& time, const std::vector<std::string>& names,
                     const std::vector<const std::vector<double>*>& columns)
{
    std::string text = "time";
    for (const auto& name : names) text += "," + name;
    for (std::size_t row = 0; row < time.size(); ++row) {
        text += fmt::format("\n{}", time[row]);
        for (const auto* column : columns) text += fmt::format(",{}", (*column)[row]);
    }
    return text + "\n";
}

/// Loads along the measured motions, and what those along the motions measured again differ from them by.
struct Loads {
    std::vector<JointLoad> loads;
    std::vector<std::vector<double>> errors;
};

Loads loads_of(const Options& options, std::vector<Moved>& all)
{
    const Robot robot = read_robot(options.robot);
    find_in_robot(robot, options, all);
    std::vector<int> indices;
    std::vector<JointMotion> motions, again;
    for (const auto& joint : all) {
        indices.push_back(joint.index);
        motions.push_back(joint.motion), again.push_back(joint.again);
    }
    const auto pose = read_pose(robot, options.pose);
    Loads of{arm_loads(robot, indices, motions, pose), {}};
    const auto others = arm_loads(robot, indices, again, pose);
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (double& inertia : of.loads[k].inertia) inertia += all[k].armature;
        auto& error = of.errors.emplace_back(others[k].load);
        for (std::size_t row = 0; row < error.size(); ++row) error[row] -= of.loads[k].load[row];
    }
    return of;
}

int arm_load(const Options& options)
{
    if (is_set(options.window) && !(options.window > 0))
        throw BadInput(fmt::format("--window: got {}, expected more than 0 s", options.window));
    std::vector<double> time;
    auto all = motions_of(options, time);
    std::vector<std::string> names;
    std::vector<const std::vector<double>*> columns;
    Loads of;
    if (options.robot.empty()) {
        for (const auto& joint : all) {
            for (const char* what : {"_position", "_velocity", "_acceleration", "_position_again", "_velocity_again",
                                     "_acceleration_again"})
                names.push_back(joint.name + what);
            for (const auto* motion : {&joint.motion, &joint.again})
                columns.insert(columns.end(), {&motion->position, &motion->velocity, &motion->acceleration});
        }
    } else {
        of = loads_of(options, all);
        for (std::size_t k = 0; k < all.size(); ++k) {
            for (const char* what : {"_load_effort", "_load_error", "_inertia"}) names.push_back(all[k].name + what);
            columns.insert(columns.end(), {&of.loads[k].load, &of.errors[k], &of.loads[k].inertia});
        }
    }
    const auto text = table_of(time, names, columns);
    if (options.file.empty())
        fmt::print("{}", text);
    else
        write_whole(options.file, text);
    return exit_done;
}

}  // namespace

void add_arm_load(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "arm-load",
        "Write load_effort, load_error and inertia of each joint of a moving arm, for the records that diagnose reads");
    verb.add_option("TABLE", options->table, "CSV with time and JOINT_position of every joint that moves, s, rad and m")
        ->required();
    verb.add_option("--robot", options->robot,
                    "URDF or MJCF; without it, smoothed positions, velocities and accelerations are written");
    verb.add_option("--at", options->pose,
                    "pose of the joints that are not in the table: TOML with joint = coordinate");
    verb.add_option("--armature", options->armature,
                    "JOINT=INERTIA: rotor inertia behind the gear that the description lacks, kg·m² (kg)");
    verb.add_option("--window", options->window,
                    "window of the cubic that gives the accelerations, s; default: 0.03, or six rows, 0.1 at most")
        ->check(positive_number());
    verb.add_option("-o,--output", options->file, "file to write; default: standard output");
    verb.footer(
        "Example: stickslip arm-load positions.csv --robot arm.urdf --armature elbow=0.12 -o loads.csv\n"
        "load_effort includes gravity: the joint file must then have no gravity of its own.\n"
        "load_error is one sample of the error of load_effort (encoder noise, corners that the cubic rounds):\n"
        "diagnose counts it as noise.\n"
        "Exit codes: 0 done, 2 bad input.");
    verb.callback([options, &invocation] { invocation.exit_code = arm_load(*options); });
}

}  // namespace stickslip
