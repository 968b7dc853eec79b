// stickslip evaluate: everything the theory says about one joint.
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "analysis/stability/frequency_search.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/evaluation_json.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/servo_text.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/surroundings_option.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/evaluation_report.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/report/write_report.h"
#include "sweep/study/evaluation.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/set_point_text.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

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

void print_rows(const Table& table)
{
    for (const auto& row : table.rows) fmt::print("  {:<40} {}\n", plain_text(row[0]), plain_text(row[1]));
}

void print_rest(const JointEvaluation& e)
{
    print_sentence(set_point_text(*e.rest, e.units()));
    print_rows(set_point_table(*e.rest, e.units()));
}

void print_text(const JointEvaluation& e, const std::string& servo)
{
    // what is open about a set point that was not asked for comes behind the answer about the motion that was
    const bool behind = e.rest && !e.only_rest() && e.rest->hunting == Hunting::undecided;
    if (e.rest && !behind) print_rest(e);
    if (!e.only_rest()) {
        if (e.open()) print_sentence(open_text(e.nonlinear));
        if (!e.contradicting.empty())
            fmt::print("{}\n", contradicted_text(e.contradicting, e.verdict.state_variable.stable));
        const auto taken = taken_out(e.nonlinear.region == NonlinearRegion::bistable, e.nonlinear);
        const auto verdict = plain_text(verdict_text(e.summed, e.verdict, taken, e.nonlinear.comes_to_rest()));
        print_sentence(e.left_out ? of_ideal_loop(verdict) : verdict);
        print_rows(linear_table(e.summed, e.verdict));
        print_rows(nonlinear_table(e.joint, e.nonlinear));
    }
    if (behind) print_rest(e);
    if (e.left_out) fmt::print("{}\n", left_out_text(e.left_out->loop, e.left_out->growth));
    for (const auto& mode : e.near) fmt::print("warning: {}\n", plain_text(near_mode_text(mode, e.units())));
    if (e.integral) fmt::print("{}\n", plain_text(integral_text(*e.integral, e.units())));
    if (!servo.empty()) fmt::print("{}\n", servo);
    if (e.motion)
        fmt::print("  {:<40} {} at {}\n", "largest linear response to the force",
                   with_unit(e.motion->peak, Quantity::position, e.units()),
                   with_unit(e.motion->peak_time, Quantity::time, e.units()));
    if (e.loads) print_rows(load_table(e.joint, *e.loads));
}

const char* stage_words(EvaluationStage stage)
{
    switch (stage) {
        case EvaluationStage::linear:
            return "the roots and the stable gains";
        case EvaluationStage::nonlinear:
            return "what the nonlinear joint does";
        case EvaluationStage::study:
            return "reductions, force ramps and critical velocities";
        case EvaluationStage::surroundings:
            return "the motion under load, and rest";
    }
    return "";
}

EvaluationQuestion question_of(const Options& options)
{
    const auto asked = read_spec_or_joint(options.joint, options.settings);
    EvaluationQuestion question;
    question.joint = asked.design;
    question.ideal_loop = options.ideal_loop;
    question.nonlinear.bifurcation = true;
    question.nonlinear.disturbance = options.disturbance.disturbance(asked.spec.nonlinear);
    question.nonlinear.rtol = asked.spec.nonlinear.tolerance;
    question.nonlinear.effort = options.effort;
    question.force = options.surroundings.force_on(asked.design);
    if (options.surroundings.loaded()) question.normal_load = options.surroundings.normal_load();
    question.study = options.json || !options.directory.empty();
    return question;
}

std::filesystem::path write_page(const JointEvaluation& e, const std::string& directory, const std::string& command)
{
    auto report = evaluation_report(e, evaluation_charts(e));
    report.provenance = {{"version", program_version()}, {"command", command}};
    return write_report(report, directory);
}

int evaluate(const Options& options, const Invocation& invocation)
{
    const auto question = question_of(options);
    say_no_sliding(options.joint, options.settings,
                   options.ideal_loop ? with_ideal_loop(question.joint) : question.joint);
    set_search_effort(options.effort);
    std::filesystem::path page;
    const JointEvaluation e = [&] {
        StageLine line(searches_less(options.effort), std::chrono::seconds(1));
        auto found = evaluate_joint(question, [&](EvaluationStage stage) { line.stage(stage_words(stage)); });
        line.stage("what its page draws");
        if (!options.directory.empty()) page = write_page(found, options.directory, invocation.command);
        return found;
    }();
    const auto servo = files::servo_text(options.joint);
    std::string json;
    if (question.study) json = evaluation_json(e, servo).dump(2) + "\n";
    if (!page.empty()) write_whole(std::filesystem::path(options.directory) / "evaluation.json", json);
    if (options.json) {
        fmt::print("{}", json);
    } else {
        print_text(e, servo);
        if (!page.empty()) fmt::print("report:  {}\n", page.string());
    }
    return e.answered() ? exit_done : exit_undecided;
}

}  // namespace

void add_evaluate(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "evaluate", "Answer for one joint: both linear theories, critical gains, spectrum, nonlinear outcome");
    verb.add_option("JOINT", options->joint, "joint description, or a spec: its design point, TOML")->required();
    verb.add_option("--set", options->settings,
                    "set a parameter first: path=value, with or without a unit (control.k_p=2e4, control.V0='1 mm/s')");
    options->disturbance.add_to(verb);
    verb.add_option("-o,--output", options->directory,
                    "also write a page with charts (both theories, disturbances, force ramps, reductions) and "
                    "evaluation.json");
    options->surroundings.add_to(verb);
    options->surroundings.add_duration_to(verb, "until the slowest mode is visible, or that of the file");
    verb.add_option("--effort", options->effort,
                    "multiple of the usual work (about a second): longer motions, more crossings and reductions of "
                    "delayed friction")
        ->check(positive_number());
    add_ideal_loop(verb, options->ideal_loop);
    verb.add_flag("--json", options->json, "machine-readable, stable names");
    verb.footer(
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml --set control.k_p=2e4 --json\n"
        "Example: stickslip evaluate examples/02-ball-screw/joint-with-memory.toml -o joint\n"
        "Exit codes: 0 decided, 2 bad input, 4 undecided.");
    verb.callback([options, &invocation] { invocation.exit_code = evaluate(*options, invocation); });
}

}  // namespace stickslip
