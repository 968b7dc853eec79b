// stickslip evaluate: everything the theory says about one joint.
#include "analysis/results/text.h"
#include "sweep/files/json/load_json.h"
#include "sweep/files/json/nonlinear_json.h"
#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/study_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/program/verbs/evaluated.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/set_point_text.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace stickslip {
namespace {

nlohmann::ordered_json forced_json(const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    return {{"kind", asked.kind},
            {"size", asked.size},
            {"duration", motion.memory.time.back()},
            {"peak", motion.peak},
            {"peak_time", motion.peak_time},
            {"final", motion.memory.position.back()}};
}

void print_rows(const Table& table)
{
    for (const auto& row : table.rows) fmt::print("  {:<40} {}\n", plain_text(row[0]), plain_text(row[1]));
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
        fmt::print("  {:<40} {} at {}\n", "largest linear response to the force",
                   with_unit(e.motion->peak, Quantity::position, e.units()),
                   with_unit(e.motion->peak_time, Quantity::time, e.units()));
    if (e.loads) print_rows(load_table(e.joint, *e.loads));
}

int evaluate(const EvaluateOptions& options, const Invocation& invocation)
{
    std::filesystem::path page;
    const Evaluated e = [&] {
        StageLine line("--effort 0.1 searches less", std::chrono::seconds(1));
        auto found = evaluated(options, line);
        line.stage("what its page draws");
        if (!options.directory.empty()) page = write_evaluated(found, options, invocation.command);
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
    auto options = std::make_shared<EvaluateOptions>();
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
    add_ideal_loop(*verb, options->ideal_loop);
    verb->add_flag("--json", options->json, "machine-readable, stable names");
    verb->footer(
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml --set control.k_p=2e4 --json\n"
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml -o joint\n"
        "Exit codes: 0 decided, 2 bad input, 4 undecided.");
    verb->callback([options, &invocation] { invocation.exit_code = evaluate(*options, invocation); });
}

}  // namespace stickslip
