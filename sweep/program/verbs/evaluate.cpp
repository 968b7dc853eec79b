// In one file: one verb. stickslip evaluate: everything the theory says about one joint.
#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/load_json.h"
#include "sweep/files/json/nonlinear_json.h"
#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/study_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/servo_text.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/surroundings_option.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/figures/disturbance_figure.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/report/write_report.h"
#include "sweep/study/open_verdict.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
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

/// The motion under the given disturbance, if any.
std::optional<DisturbedMotion> disturbed(const Joint& joint, const AskedDisturbance& force)
{
    if (force.kind.empty()) return std::nullopt;
    return disturbed_motion(joint, force);
}

/// What the theory says over the given record of the normal load.
std::optional<LoadStudy> loaded(const Joint& joint, const SurroundingsOption& surroundings)
{
    if (!surroundings.loaded()) return std::nullopt;
    const auto record = surroundings.normal_load();
    return load_study(joint, record.sampled(record.duration() / sampled_disturbance, sampled_disturbance));
}

nlohmann::ordered_json forced_json(const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    return {{"kind", asked.kind},
            {"size", asked.size},
            {"duration", motion.memory.time.back()},
            {"peak", motion.peak},
            {"peak_time", motion.peak_time},
            {"final", motion.memory.position.back()}};
}

/// At a set point: of a loop that integrates or has something against dry friction there, and where that is commanded.
std::optional<SetPoint> resting(const Joint& joint)
{
    const auto& c = joint.control;
    const bool helped = c.feed_forward.fed_back() || c.dither.amplitude > 0;
    if (!integrates(joint) && !helped && c.V0 != 0) return std::nullopt;
    return set_point(joint);
}

void print_rows(const Table& table)
{
    for (const auto& row : table.rows) fmt::print("  {:<40} {}\n", plain_text(row[0]), plain_text(row[1]));
}

/// Everything that one evaluation found.
struct Evaluated {
    Joint joint;
    Joint summed;  ///< pages and studies turn k_p, which a cascade has only as part of its sum of gains
    LinearVerdict verdict;
    NonlinearVerdict nonlinear;
    std::optional<LinearStudy> study;  ///< for JSON and pages
    std::optional<DisturbedMotion> motion;
    std::optional<LoadStudy> loads;
    std::optional<SetPoint> rest;
    std::vector<NearMode> near;
    std::vector<std::string> contradicting;  ///< terms by which the motion does the opposite of the linear theory
    std::optional<IntegralCost> integral;
    std::string servo;
    std::optional<Joint> described;  ///< with the loop that --ideal-loop leaves out
    double described_growth = missing;

    bool decided() const { return verdict.steady.reason == Reason::none; }
    bool open() const { return decided() && is_open(nonlinear); }
    bool answered() const { return only_rest() ? rest->hunting != Hunting::undecided : decided() && !open(); }
    bool only_rest() const { return rest && (joint.control.V0 == 0 || (!is_set(joint.control.V0) && !decided())); }
    Units units() const { return units_of(joint); }
};

Evaluated evaluated(const Options& options, StageLine& line)
{
    auto asked = read_spec_or_joint(options.joint, options.settings);
    const Joint described = asked.design;
    if (options.ideal_loop) {
        asked.design = with_ideal_loop(asked.design);
        asked.spec.joint = with_ideal_loop(asked.spec.joint);
    }
    say_no_sliding(options.joint, options.settings, asked.design);
    set_search_effort(options.effort);
    Evaluated e;
    e.joint = asked.design;
    line.stage("the roots and the stable gains");
    e.verdict = linear_verdict(e.joint);
    add_margins(e.joint, e.verdict);
    e.summed = acting_joint(e.joint);
    NonlinearOptions nonlinear;
    nonlinear.bifurcation = true;
    nonlinear.disturbance = options.disturbance.disturbance(asked.spec.nonlinear);
    nonlinear.rtol = asked.spec.nonlinear.tolerance;
    nonlinear.effort = options.effort;
    line.stage("what the nonlinear joint does");
    e.nonlinear = nonlinear_verdict(e.joint, nonlinear);
    line.stage("reductions, force ramps and critical velocities");
    if (options.json || !options.directory.empty()) e.study = linear_study(e.summed);
    line.stage("the motion under load, and rest");
    if (e.decided()) {
        e.motion = disturbed(e.summed, options.surroundings.force);
        e.loads = loaded(e.summed, options.surroundings);
    }
    e.rest = resting(e.joint);
    e.near = near_modes(e.joint);
    e.contradicting = contradicting_terms(e.verdict, e.nonlinear);
    e.integral = integral_cost(e.joint, e.verdict);
    e.servo = files::servo_text(options.joint);
    if (options.ideal_loop && !left_out_by_ideal(described).used.empty()) {
        e.described = described.control.structure == Structure::cascade ? with_gains(described) : described;
        e.described_growth = growth_rate(described);
    }
    return e;
}

std::filesystem::path write_page(const Evaluated& e, const Options& options, const std::string& command)
{
    const auto answer = answer_joint(e.summed, e.verdict, e.nonlinear, *e.study);
    auto report = linear_report(e.summed, answer);
    const auto& own = e.verdict.state_variable.stable_intervals;
    const BothLoops both =
        e.described ? BothLoops{own, stable_gains(*e.described).stable} : BothLoops{answer.ideal_gains, own};
    if (const auto chart = gain_chart(e.described ? *e.described : e.summed))
        report.sections.insert(report.sections.begin(), gains_section(e.units(), both, *chart));
    if (e.described) {
        const bool same = (e.described_growth < 0) == e.verdict.state_variable.stable;
        report.alerts.push_back({same ? Headline::Tone::neutral : Headline::Tone::warning,
                                 left_out_text(left_out_by_ideal(*e.described), e.described_growth)});
        report.verdict = of_ideal_loop(report.verdict);
        // what the loop as it is does not do is no clean yes
        if (!same && report.tone == Headline::Tone::good) report.tone = Headline::Tone::warning;
    }
    if (e.verdict.steady.reason == Reason::limit_too_low)
        report.alerts.push_back({Headline::Tone::bad, low_limit_text(e.joint)});
    report.provenance = {{"version", program_version()}, {"command", command}};
    if (e.motion)
        for (auto& section : report.sections)
            if (section.id == "response")
                section.figures.push_back(disturbance_figure(e.joint, options.surroundings.force, *e.motion));
    if (e.open()) {
        report.verdict = open_text(e.nonlinear) + " " + report.verdict;
        if (report.tone == Headline::Tone::good) report.tone = Headline::Tone::warning;
    }
    if (!e.contradicting.empty()) {
        report.verdict = contradicted_text(e.contradicting, e.verdict.state_variable.stable) + " " + report.verdict;
        report.tone = e.verdict.state_variable.stable ? Headline::Tone::bad : Headline::Tone::warning;
    }
    if (e.only_rest()) report.verdict = set_point_text(*e.rest, e.units());
    if (e.rest) report.sections.insert(report.sections.end() - 1, set_point_section(*e.rest, e.units()));
    if (e.loads) report.sections.insert(report.sections.end() - 1, load_section(e.joint, *e.loads));
    for (const auto& mode : e.near) report.alerts.push_back(near_mode_alert(mode, e.units()));
    if (e.integral)
        report.alerts.push_back({e.integral->with > 0 ? Headline::Tone::neutral : Headline::Tone::warning,
                                 integral_text(*e.integral, e.units())});
    return write_report(report, options.directory);
}

nlohmann::ordered_json evaluate_json(const Evaluated& e, const AskedDisturbance& force)
{
    nlohmann::ordered_json json = {{"format", "stickslip-evaluate/1"}, {"decided", e.answered()}};
    json.update(verdict_json(e.verdict));
    if (e.decided()) json["linear"].update(study_json(e.summed, *e.study));
    if (e.motion) json["linear"]["forced"] = forced_json(force, *e.motion);
    if (e.loads) json["linear"]["normal_load"] = load_json(*e.loads);
    json["nonlinear"] = nonlinear_json(e.nonlinear);
    json["contradicting_terms"] = e.contradicting;
    for (const auto& mode : e.near)
        json["warnings"].push_back({{"code", "neighbour-mode"},
                                    {"neighbour", mode.neighbour},
                                    {"omega", mode.omega},
                                    {"friction_omega", mode.friction}});
    if (e.rest) json["set_point"] = set_point_json(*e.rest);
    if (e.integral)
        json["linear"]["integral_cost"] = {
            {"margin", e.integral->with}, {"margin_without", e.integral->without}, {"share", e.integral->share()}};
    if (e.described) {
        json["notes"].push_back(left_out_text(left_out_by_ideal(*e.described), e.described_growth));
        json["note_codes"].push_back("ideal-loop");
    }
    if (!e.servo.empty()) json["notes"].push_back(e.servo), json["note_codes"].push_back("servo");
    return json;
}

void print_text(const Evaluated& e)
{
    if (e.rest) fmt::print("{}\n", plain_text(set_point_text(*e.rest, e.units())));
    if (e.rest) print_rows(set_point_table(*e.rest, e.units()));
    if (!e.only_rest()) {
        if (e.open()) fmt::print("{}\n", plain_text(open_text(e.nonlinear)));
        if (!e.contradicting.empty())
            fmt::print("{}\n", contradicted_text(e.contradicting, e.verdict.state_variable.stable));
        const bool bistable = e.nonlinear.region == NonlinearRegion::bistable;
        const auto verdict = plain_text(verdict_text(e.summed, e.verdict, bistable));
        fmt::print("{}\n", e.described ? of_ideal_loop(verdict) : verdict);
        print_rows(linear_table(e.summed, e.verdict));
        print_rows(nonlinear_table(e.joint, e.nonlinear));
    }
    if (e.described) fmt::print("{}\n", left_out_text(left_out_by_ideal(*e.described), e.described_growth));
    for (const auto& mode : e.near) fmt::print("warning: {}\n", plain_text(near_mode_text(mode, e.units())));
    if (e.integral) fmt::print("{}\n", plain_text(integral_text(*e.integral, e.units())));
    if (!e.servo.empty()) fmt::print("{}\n", e.servo);
    if (e.motion)
        fmt::print("  {:<40} {} at {}\n", "largest linear answer to the force",
                   with_unit(e.motion->peak, Quantity::position, e.units()),
                   with_unit(e.motion->peak_time, Quantity::time, e.units()));
    if (e.loads) print_rows(load_table(e.joint, *e.loads));
}

int evaluate(const Options& options, const Invocation& invocation)
{
    std::filesystem::path page;
    const Evaluated e = [&] {
        StageLine line("--effort 0.1 searches less", std::chrono::seconds(1));
        auto found = evaluated(options, line);
        line.stage("what its page draws");
        if (!options.directory.empty()) page = write_page(found, options, invocation.command);
        return found;
    }();
    if (options.json) {
        fmt::print("{}\n", evaluate_json(e, options.surroundings.force).dump(2));
    } else {
        print_text(e);
        if (!page.empty()) fmt::print("report:  {}\n", page.string());
    }
    return e.answered() ? exit_done : exit_undecided;
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
        "set a parameter first: path=value, with or without a unit (control.k_p=2e4, control.V0='1 mm/s')");
    options->disturbance.add_to(*verb);
    verb->add_option("-o,--output", options->directory,
                     "also write a page with charts: both theories, disturbances, force ramps, reductions");
    options->surroundings.add_to(*verb);
    options->surroundings.add_duration_to(*verb, "until the slowest mode is visible, or that of the file");
    verb->add_option("--effort", options->effort,
                     "multiple of the usual work (about a second): longer motions, more crossings and reductions of "
                     "delayed friction")
        ->check(positive_number());
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
