// stickslip evaluate: everything the theory says about one joint.
#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/verdict.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/nonlinear_json.h"
#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/study_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/servo_text.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/surroundings_option.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/figures/disturbance_figure.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/report/pages/write_report.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/set_point_text.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace stickslip {
namespace {

struct Options {
    std::string joint, directory;
    std::vector<std::string> settings;
    DisturbanceOption disturbance;
    SurroundingsOption surroundings;
    double effort = 1;
    bool json = false, ideal_loop = false;
};

/// The motion under the asked disturbance, where one is asked and the joint slides.
std::optional<DisturbedMotion> disturbed(const Joint& joint, const AskedDisturbance& force)
{
    if (force.kind.empty()) return std::nullopt;
    return disturbed_motion(joint, force);
}

/// What the theory says over the asked record of the normal load.
std::optional<LoadStudy> loaded(const Joint& joint, const SurroundingsOption& surroundings)
{
    if (!surroundings.loaded()) return std::nullopt;
    const auto record = surroundings.normal_load();
    return load_study(joint, record.sampled(record.duration() / sampled_disturbance, sampled_disturbance));
}

nlohmann::ordered_json load_json(const LoadStudy& study)
{
    nlohmann::ordered_json json = {
        {"low", study.low},
        {"high", study.high},
        {"stable_share",
         {{"velocity_only", study.stable_velocity_only}, {"state_variable", study.stable_state_variable}}},
        {"hardest", json_number(study.hardest_load)},
        {"k_cr", json_number(study.hardest_k_cr)}};
    auto& levels = json["levels"] = nlohmann::ordered_json::array();
    for (const auto& v : study.at)
        levels.push_back({{"load", v.load},
                          {"velocity_only",
                           {{"spectral_abscissa", json_number(v.velocity_only)}, {"k_v_min", json_number(v.k_v_min)}}},
                          {"state_variable",
                           {{"spectral_abscissa", json_number(v.state_variable)}, {"k_cr", json_number(v.k_cr)}}}});
    return json;
}

nlohmann::ordered_json motion_json(const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    return {{"kind", asked.kind},
            {"size", asked.size},
            {"duration", motion.memory.time.back()},
            {"peak", motion.peak},
            {"peak_time", motion.peak_time},
            {"final", motion.memory.position.back()}};
}

/// What it does at a set point: asked of a loop that integrates, and of one whose set point is all that is commanded.
std::optional<SetPoint> resting(const Joint& joint)
{
    if (!integrates(joint) && joint.control.V0 != 0) return std::nullopt;
    return set_point(joint);
}

void print_rows(const Table& table)
{
    for (const auto& row : table.rows) fmt::print("  {:<40} {}\n", plain_text(row[0]), plain_text(row[1]));
}

int evaluate(const Options& options, const Invocation& invocation)
{
    auto asked = read_spec_or_joint(options.joint, options.settings);
    if (options.ideal_loop) {
        asked.design = with_ideal_loop(asked.design);
        asked.spec.joint = with_ideal_loop(asked.spec.joint);
    }
    const Joint& joint = asked.design;
    set_search_effort(options.effort);
    auto verdict = linear_verdict(joint);
    add_margins(joint, verdict);
    // pages and studies turn k_p, which a cascade has only as part of its sum of gains
    const Joint summed = joint.control.structure == Structure::cascade ? with_gains(joint) : joint;
    NonlinearOptions nonlinear_options;
    nonlinear_options.bifurcation = true;
    nonlinear_options.disturbance = options.disturbance.disturbance(asked.spec.nonlinear);
    nonlinear_options.rtol = asked.spec.nonlinear.tolerance;
    const auto nonlinear = nonlinear_verdict(joint, nonlinear_options);
    const bool decided = verdict.steady.reason == Reason::none;
    std::optional<LinearStudy> study;
    if (options.json || !options.directory.empty()) study = linear_study(summed);
    const auto& force = options.surroundings.force;
    const auto motion = decided ? disturbed(summed, force) : std::nullopt;
    const auto loads = decided ? loaded(summed, options.surroundings) : std::nullopt;
    const auto rest = resting(joint);
    const bool only_rest = rest && (joint.control.V0 == 0 || (!is_set(joint.control.V0) && !decided));
    const Motion units = joint.mechanism.motion;
    const auto near = near_modes(joint);
    const auto integral = integral_cost(joint, verdict);
    const auto servo = files::servo_text(options.joint);
    std::filesystem::path page;
    if (!options.directory.empty()) {
        const auto answer = answer_joint(summed, verdict, nonlinear, *study);
        auto report = linear_report(summed, answer);
        if (const auto chart = gain_chart(summed))
            report.sections.insert(report.sections.begin(), gains_section(summed, answer, *chart));
        report.provenance = {{"version", program_version()}, {"command", invocation.command}};
        if (motion)
            for (auto& section : report.sections)
                if (section.id == "response") section.figures.push_back(disturbance_figure(joint, force, *motion));
        if (rest && only_rest) report.verdict = set_point_text(*rest, units);
        if (rest) report.sections.insert(report.sections.end() - 1, set_point_section(*rest, units));
        if (loads) report.sections.insert(report.sections.end() - 1, load_section(joint, *loads));
        for (const auto& mode : near) report.alerts.push_back(near_mode_alert(mode, units));
        if (integral)
            report.alerts.push_back({integral->with > 0 ? Headline::Tone::neutral : Headline::Tone::warning,
                                     integral_text(*integral, units)});
        page = write_report(report, options.directory);
    }
    if (options.json) {
        nlohmann::ordered_json json = {{"format", "stickslip-evaluate/1"}};
        json.update(verdict_json(verdict));
        if (decided) json["linear"].update(study_json(summed, *study));
        if (motion) json["linear"]["forced"] = motion_json(force, *motion);
        if (loads) json["linear"]["normal_load"] = load_json(*loads);
        json["nonlinear"] = nonlinear_json(nonlinear);
        for (const auto& mode : near)
            json["warnings"].push_back({{"code", "neighbour-mode"},
                                        {"neighbour", mode.neighbour},
                                        {"omega", mode.omega},
                                        {"friction_omega", mode.friction}});
        if (rest) json["set_point"] = set_point_json(*rest);
        if (integral)
            json["linear"]["integral_cost"] = {
                {"margin", integral->with}, {"margin_without", integral->without}, {"share", integral->share()}};
        if (!servo.empty()) json["notes"].push_back(servo);
        fmt::print("{}\n", json.dump(2));
    } else {
        if (rest) fmt::print("{}\n", plain_text(set_point_text(*rest, units)));
        if (rest) print_rows(set_point_table(*rest, units));
        if (!only_rest) {
            fmt::print("{}\n", plain_text(verdict_text(summed, verdict)));
            print_rows(linear_table(summed, verdict));
            print_rows(nonlinear_table(joint, nonlinear));
        }
        for (const auto& mode : near) fmt::print("warning: {}\n", plain_text(near_mode_text(mode, units)));
        if (integral) fmt::print("{}\n", plain_text(integral_text(*integral, units)));
        if (!servo.empty()) fmt::print("{}\n", servo);
        if (motion)
            fmt::print("  {:<40} {} at {}\n", "largest linear answer to the force",
                       with_unit(motion->peak, Quantity::position, joint.mechanism.motion),
                       with_unit(motion->peak_time, Quantity::time, joint.mechanism.motion));
        if (loads) print_rows(load_table(joint, *loads));
        if (!page.empty()) fmt::print("report:  {}\n", page.string());
    }
    if (only_rest) return rest->hunting == Hunting::undecided ? exit_undecided : exit_done;
    const bool half = nonlinear.outcome == Outcome::stable_sliding && nonlinear.region == NonlinearRegion::undecided;
    const bool failed = nonlinear.outcome == Outcome::undecided || nonlinear.outcome == Outcome::solver_failure || half;
    return decided && !failed ? exit_done : exit_undecided;
}

}  // namespace

void add_evaluate(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* verb = app.add_subcommand(
        "evaluate", "Answer for one joint: both linear theories, critical gains, spectrum, nonlinear outcome");
    verb->add_option("JOINT", options->joint, "joint description, or a spec: its design point, TOML")->required();
    verb->add_option(
        "--set", options->settings,
        "change a number first: path=value, with or without a unit (control.k_p=2e4, control.V0='1 mm/s')");
    options->disturbance.add_to(*verb);
    verb->add_option("-o,--output", options->directory,
                     "also write a page with charts: both theories, disturbances, force ramps, reductions");
    options->surroundings.add_to(*verb);
    options->surroundings.add_duration_to(*verb, "until the slowest mode has shown itself, or the file's");
    verb->add_option("--effort", options->effort,
                     "how much searching, per the usual: more crossings and reductions of friction that answers late")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--ideal-loop", options->ideal_loop,
                   "the paper's loop: no sampling, dead time, filter, lag or integral");
    verb->add_flag("--json", options->json, "machine-readable, stable names");
    verb->footer(
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml --set control.k_p=2e4 --json\n"
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml -o joint\n"
        "Exit codes: 0 decided, 2 bad input, 4 undecided.");
    verb->callback([options, &invocation] { invocation.exit_code = evaluate(*options, invocation); });
}

}  // namespace stickslip
