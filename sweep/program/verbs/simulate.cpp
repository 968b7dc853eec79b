// stickslip simulate: one motion of one joint, as numbers and pictures.
#include "analysis/simulation/simulate.h"
#include "analysis/joint/loop_side.h"
#include "analysis/results/text.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/motion_measures.h"
#include "analysis/stability/steady.h"

#include "sweep/engine/build.h"
#include "sweep/files/json/motion_json.h"
#include "sweep/files/records/reference_file.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/surroundings_option.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/record_report.h"
#include "sweep/report/pages/trajectory_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/loop_growth.h"
#include "sweep/study/motion_curves.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>
#include <fmt/os.h>

#include <filesystem>
#include <map>
#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string joint, directory = "out";
    std::vector<std::string> settings;
    DisturbanceOption disturbance;
    SurroundingsOption surroundings;
    double tolerance = 1e-8;
    std::string reference;
    double effort = 1;
    bool ideal_loop = false;
};

/// What acts on the joint from outside, as numbers and for the page.
SimulatedSurroundings surround(const Joint& joint, const SurroundingsOption& asked, SimulateOptions& simulation)
{
    SimulatedSurroundings shown;
    simulation.duration = asked.force.duration;
    const bool slides = steady_sliding(joint).reason == Reason::none;
    if (!asked.force.kind.empty() && slides) {
        shown.linear = disturbed_motion(joint, asked.force_on(joint));
        simulation.force = shown.linear->force;
        const double shown_for = simulation.force.step * static_cast<double>(simulation.force.value.size());
        if (!is_set(simulation.duration)) simulation.duration = shown_for;
    }
    if (asked.loaded()) {
        const auto record = asked.normal_load();
        if (!is_set(simulation.duration)) simulation.duration = record.duration();
        auto& load = simulation.normal_load;
        load.step = simulation.duration / sampled_disturbance;
        load.value = record.sampled(load.step, sampled_disturbance);
        shown.normal_load = load;
    }
    return shown;
}

/// trajectory.csv, one row a step of the solver.
std::filesystem::path write_trajectory(const Joint& joint, const Trajectory& t, const std::vector<double>& force,
                                       const std::filesystem::path& directory)
{
    const auto file = directory / "trajectory.csv";
    const Units units = units_of(joint);
    const bool forces = !force.empty();
    auto text = fmt::format("time [s],excess_position [{}],velocity [{}],friction [{}],stuck",
                            unit_of(Quantity::position, units), unit_of(Quantity::velocity, units),
                            unit_of(Quantity::effort, units));
    text += forces ? fmt::format(",control_force [{}]\n", unit_of(Quantity::effort, units)) : "\n";
    for (std::size_t i = 0; i < t.time.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", t.time[i], t.position[i], t.velocity[i],
                       t.friction[i], static_cast<int>(t.stuck[i]));
        text += forces ? fmt::format(",{}\n", force[i]) : "\n";
    }
    write_whole(file, text);  // a full disk is said, not met by the destructor of a stream
    return file;
}

/// Overshoot, settling time and stairs, on the terminal and as motion.json beside the motion.
void tell_measures(const MotionMeasures& m, Units units, const std::filesystem::path& directory)
{
    write_whole(directory / "motion.json", motion_json(m, units).dump(2) + "\n");
    const auto tell = [&](const char* name, double value, Quantity quantity) {
        if (is_set(value)) fmt::print("{:<11} {}\n", name, plain_text(with_unit(value, quantity, units, 4)));
    };
    tell("overshoot:", m.overshoot, Quantity::position);
    tell("settles in:", m.settling_time, Quantity::time);
    tell("stairs of:", m.stair_height, Quantity::position);
    tell("stairs at:", m.stair_rate, Quantity::rate);
}

/// Of a simulation that could not go on.
void tell_end(double time, const std::string& why)
{
    fmt::print("it ends at {}: {}\n", plain_text(with_unit(time, Quantity::time, {}, 6)), why);
}

/// Of a motion about steady sliding, whose positions count from the steady path.
MotionMeasures measured(const Trajectory& trajectory, double velocity)
{
    std::vector<double> reference, position;
    for (std::size_t i = 0; i < trajectory.time.size(); ++i) {
        reference.push_back(velocity * trajectory.time[i]);
        position.push_back(reference.back() + trajectory.position[i]);
    }
    return measure_motion(trajectory.time, reference, position);
}

/// --reference: the record that the joint's controller would have logged.
int record_joint(const Options& options, const Invocation& invocation)
{
    auto asked = read_spec_or_joint(options.joint, options.settings);
    if (options.ideal_loop) leave_loop_out(asked);
    const Joint& joint = asked.design;
    say_no_sliding(options.joint, options.settings, with_loop_at_joint(joint));
    const auto reference = read_reference(options.reference, units_of(joint));
    const auto record = record_along(joint, reference, options.surroundings.force.seed, options.tolerance);
    if (record.time.empty()) throw BadInput(options.joint + ": cannot follow a reference: " + detail_text(record.why));
    fmt::print("record:     {}\n", write_record(record, options.directory).string());
    if (const auto side = gear_side(joint); side.between()) fmt::print("{}\n", plain_text(side_text(side, true)));
    constexpr double spread = 4;  // standard deviations of the noise that a reading may be off
    const double noise = options.surroundings.force.seed > 0 ? spread * joint.sensor.position_noise : 0;
    const double reading_error = 0.5 * joint.sensor.encoder_quantum + noise;
    const auto read = measure_motion(record.time, record.reference_position, record.position, reading_error);
    tell_measures(per_reading(read, joint.sensor.position_scale), units_of(joint), options.directory);
    const auto unstable = unstable_loop(joint, record);
    const auto loop = unstable ? unstable_loop_text(*unstable, units_of(joint)) : std::string();
    if (unstable) fmt::print("{}\n", plain_text(loop));
    auto report = record_report(joint, {record.time, record.reference_position, record.position, record.effort_command,
                                        record.effort_measured, detail_text(record.why), loop});
    report.provenance = {{"version", program_version()}, {"command", invocation.command}};
    fmt::print("report:     {}\n", write_report(report, options.directory).string());
    if (record.reason == Reason::none) return exit_done;
    tell_end(record.time.back(), detail_text(record.why));
    return exit_undecided;
}

int simulate_joint(const Options& options, const Invocation& invocation)
{
    auto asked = read_spec_or_joint(options.joint, options.settings);
    if (options.ideal_loop) leave_loop_out(asked);
    const Joint& joint = asked.design;
    say_no_sliding(options.joint, options.settings, joint);
    SimulateOptions simulation;
    simulation.disturbance = options.disturbance.disturbance(asked.spec.nonlinear);
    simulation.rtol = options.tolerance;
    simulation.seed = options.surroundings.force.seed;
    const auto surroundings = surround(joint, options.surroundings, simulation);
    NonlinearOptions outcome;
    outcome.disturbance = simulation.disturbance;
    outcome.rtol = simulation.rtol;
    outcome.effort = options.effort;
    const auto verdict = nonlinear_verdict(joint, outcome);
    simulation.cycle_period = verdict.period;
    const auto trajectory = simulate(joint, simulation);
    const auto curves = motion_curves(joint, trajectory);
    auto report = trajectory_report(joint, trajectory, verdict, surroundings, curves);
    report.provenance = {{"version", program_version()}, {"command", invocation.command}};
    print_sentence(report.verdict);
    if (trajectory.time.empty()) return exit_undecided;
    fmt::print("trajectory: {}\n",
               write_trajectory(joint, trajectory, curves.control_force, options.directory).string());
    tell_measures(measured(trajectory, sliding_velocity(joint)), units_of(joint), options.directory);
    fmt::print("report:     {}\n", write_report(report, options.directory).string());
    if (trajectory.reason == Reason::none) return exit_done;
    tell_end(trajectory.time.back(), plain_text(stop_text(trajectory)));
    return exit_undecided;
}

}  // namespace

void add_simulate(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "simulate", "One motion of one joint: trajectory.csv, time series, phase portrait, friction-velocity loop");
    verb.add_option("JOINT", options->joint, "joint description, or a spec: its design point, TOML")->required();
    verb.add_option("-o,--output", options->directory, "directory of the files")->capture_default_str();
    verb.add_option("--set", options->settings, "set a parameter first: path=value");
    options->disturbance.add_to(verb);
    options->surroundings.add_to(verb);
    options->surroundings.add_duration_to(
        verb,
        "fifty turns of the slowest mode, up to 400 where it grows slowly, at most 100000 ticks; with a "
        "force until the mode has shown itself; a file's own");
    verb.add_option("--reference", options->reference,
                    "follow this reference instead and write record.csv, which diagnose reads: CSV with time, "
                    "reference_position and, where it has them, reference_velocity and feed_forward")
        ->check(existing_file());
    verb.add_flag("--ideal-loop", options->ideal_loop,
                  "the paper's loop: no sampling, dead time, filter, lag or integral");
    verb.add_option("--effort", options->effort,
                    "multiple of the usual work that the search for where the motion ends may take")
        ->check(positive_number());
    verb.add_option("--tolerance", options->tolerance, "relative tolerance")
        ->check(between(1e-13, 1e-2))
        ->capture_default_str();
    verb.footer(
        "Example: stickslip simulate examples/02-ball-screw/joint-with-memory.toml --set control.k_v=0 --set "
        "control.k_p=5e4 -o out\n"
        "Example: stickslip simulate joint.toml --reference motion.csv --seed 7 -o out\n"
        "Example: stickslip simulate joint.toml --force sine --force-size 0.1 --omega 60 -o out\n"
        "Example: stickslip simulate joint.toml --normal-load record.csv --nominal-load 250 -o out");
    verb.callback([options, &invocation] {
        invocation.exit_code =
            options->reference.empty() ? simulate_joint(*options, invocation) : record_joint(*options, invocation);
    });
}

}  // namespace stickslip
