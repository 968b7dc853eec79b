// stickslip sweep: from a spec to results.nc and report.html.
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/engine/run_directory.h"
#include "sweep/engine/run_on_cluster.h"
#include "sweep/files/json/sweep_answer_file.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/program/verbs/embedded.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/no_sliding.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/progress_line.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/shell_word.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/timestamp.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/stability_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/evaluate_points.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/robot_description_text.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <memory>
#include <tuple>

namespace stickslip {
namespace {

struct Options {
    std::string spec, directory = "out", shard, timestamp;
    int threads = 0;
    double max_undecided = 0.05;
    bool fresh = false, keep_journal = false, json = false, no_report = false, ideal_loop = false, every_point = false;
};

/// "2/7": the second of seven shards.
Shard shard_from(const std::string& text)
{
    if (text.empty()) return {};
    unsigned long long index = 0, count = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%llu/%llu%c", &index, &count, &rest) != 2 || index < 1 || index > count)
        throw BadInput("--shard: got " + text + ", expected i/n with 1 ≤ i ≤ n");
    return {index - 1, count};
}

int end_early(const RunReport& run, const std::string& directory)
{
    if (run.end == RunEnd::write_failed) {
        say("stickslip: {}\nThe journal is safe: free some space and run the same command again.\n", run.message);
        return exit_interrupted;
    }
    say("interrupted after {} points; the same command continues from there (journals in {})\n", run.computed.points,
        directory);
    return exit_interrupted;
}

PlanOptions plan_options_of(const Options& options, const Spec& spec)
{
    PlanOptions plan_options;
    plan_options.evaluation = evaluation_text(spec.nonlinear, spec.axes);
    plan_options.nonlinear = spec.nonlinear.enabled;
    plan_options.dense = is_dense(spec.nonlinear, spec.axes);
    plan_options.seconds_per_point = seconds_per_point(spec.nonlinear, spec.joint);
    plan_options.title = spec.title;
    plan_options.spec = options.spec.empty() ? std::string(embedded_spec()) : self_contained_text(options.spec);
    plan_options.command = options.spec.empty() ? "stickslip sweep" : "stickslip sweep " + shell_word(options.spec);
    if (options.every_point) plan_options.command += " --every-point";
    if (options.ideal_loop) plan_options.command += " --ideal-loop";
    return plan_options;
}

/// What came of it, on standard output; `page` is empty where no report was requested.
void tell(const Options& options, const SweepSummary& summary, const Json& loop, const Json& idle, double bound,
          const RunReport& run, const std::string& answer, const std::filesystem::path& page, double seconds)
{
    if (options.json) {
        nlohmann::ordered_json json{{"format", "stickslip-sweep-run/1"},
                                    {"points", summary.points},
                                    {"computed", run.computed.points},
                                    {"undecided", summary.undecided},
                                    {"held", summary.held},
                                    {"interpolated", summary.interpolated},
                                    {"loop", loop},
                                    {"idle", idle},
                                    {"results", absolute(run.results).string()},
                                    {"report", nullptr}};
        if (!page.empty()) json["report"] = absolute(page).string();
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("{}", answer);
        fmt::print("{}, {} of them computed now, {} undecided; {:.2f} s in all\n", counted(summary.points, "point"),
                   run.computed.points, summary.undecided, seconds);
        if (summary.interpolated > 0)
            fmt::print("  {} interpolated to within {:.3g} % (nonlinear.interpolation; --every-point computes all)\n",
                       counted(summary.interpolated, "point"), 100 * bound);
        if (summary.held > 0)
            fmt::print("  {} at rest for good: the limits leave less effort than breaks static friction\n",
                       counted(summary.held, "point"));
        for (const auto& [reason, count] : summary.reasons)
            fmt::print("  {}: {}\n", counted(count, "point"), reason_text(reason));
        fmt::print("results: {}\n", (std::filesystem::path(options.directory) / run_files::results).string());
        if (!page.empty()) fmt::print("report:  {}\n", page.string());
    }
}

/// What the terminal says of the page, and where it is.
std::pair<std::string, std::filesystem::path> draw_page(const Spec& spec, const SweepSummary& summary,
                                                        const std::string& text,
                                                        const std::optional<LeftOutLoop>& left_out,
                                                        const std::string& directory)
{
    auto stored = answer_sweep(spec, summary);
    stored.spec = text;
    stored.left_out = left_out;
    write_sweep_answer(stored, directory);
    const auto report = stability_report(spec, summary, stored);
    return {terminal_summary(report), write_sweep_report(report, spec, text, directory)};
}

int sweep(const Options& options, Invocation& invocation)
{
    const auto start = std::chrono::steady_clock::now();
    const auto date = timestamp(options.timestamp);
    Spec spec = options.spec.empty() ? read_spec_text(embedded_spec(), "(embedded example)") : read_spec(options.spec);
    if (options.every_point) spec.nonlinear.interpolation = 0;
    const auto left_out = options.ideal_loop ? leave_loop_out(spec) : std::nullopt;
    choose_charts(spec);
    if (!options.spec.empty()) say_no_sliding(options.spec, {}, design_joint(spec));

    const auto idle = idle_axes(design_joint(spec), spec.axes);
    for (const auto& axis : idle) say("note: {}\n", idle_words(axis));
    for (const auto& text : unreachable_poses_text(spec.joint, spec.axes)) say("note: {}\n", text);

    const PlanOptions plan_options = plan_options_of(options, spec);
    const Plan plan = make_plan(spec.joint, spec.axes, plan_options);

    ProgressLine line;
    RunOptions run_options;
    run_options.directory = options.directory;
    run_options.fresh = options.fresh;
    run_options.keep_journal = options.keep_journal;
    run_options.shard = shard_from(options.shard);
    run_options.engine.threads = options.threads;
    run_options.engine.interrupt = &invocation.interrupted;
    if (line.shown()) run_options.engine.progress = [&](const Progress& p) { line.update(p); };
    catch_interrupts(invocation);
    const auto evaluate = evaluator(spec.nonlinear, plan.axes);
    const auto run = invocation.cluster ? run_on_cluster(plan, spec.joint, evaluate, run_options, *invocation.cluster)
                                        : run_sweep(plan, spec.joint, evaluate, run_options);
    line.end();
    if (run.end != RunEnd::complete) return end_early(run, options.directory);
    if (invocation.cluster && invocation.cluster->rank() != 0) return exit_done;  // rank 0 reports for all
    if (!run_options.shard.whole()) {
        fmt::print("shard {} done; when all are: stickslip merge {}\n", options.shard, shell_word(options.directory));
        return exit_done;
    }

    leave_on_interrupts("interrupted: the results are kept, their page is not drawn; stickslip report draws it\n");
    const ResultsFile results(run.results);
    auto summary = summarise(spec, results);
    if (!date.empty()) summary.provenance.emplace_back("drawn", date);
    const Joint design = design_joint(spec);
    const auto verdict = linear_verdict(design);
    const double undecided = static_cast<double>(summary.undecided) / static_cast<double>(summary.points);
    std::filesystem::path page;
    std::string answer = plain_text(verdict_text(design, verdict)) + "\n";
    if (left_out) answer = of_ideal_loop(answer);
    if (!options.no_report) {
        line.say_next("computing the answers for the design, drawing the page");
        std::tie(answer, page) = draw_page(spec, summary, plan_options.spec, left_out, options.directory);
        line.end();
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    tell(options, summary, loop_json(verdict.loop, left_out), idle_json(idle), spec.nonlinear.interpolation, run,
         answer, page, wall.count());
    return undecided > options.max_undecided ? exit_undecided : exit_done;
}

}  // namespace

void add_sweep(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("sweep", "Sweep a design space: results.nc and report.html");
    verb.add_option("SPEC", options->spec, "sweep spec, TOML; without it the embedded example runs");
    verb.add_option("-o,--output", options->directory, "directory of the results; an interrupted sweep resumes there")
        ->capture_default_str();
    add_threads(verb, options->threads, "number of threads; 0: all cores")->capture_default_str();
    verb.add_option("--shard", options->shard, "compute only part i of n, as i/n; then: stickslip merge DIR");
    verb.add_option("--max-undecided", options->max_undecided,
                    "exit 4 if more than this share of the points is undecided")
        ->check(between(0, 1))
        ->capture_default_str();
    verb.add_flag("--fresh", options->fresh, "discard an earlier sweep in the directory");
    verb.add_flag("--keep-journal", options->keep_journal, "keep the journal, as large as the results");
    verb.add_flag("--no-report", options->no_report, "write results.nc only");
    verb.add_option("--timestamp", options->timestamp,
                    "date on the page: now, or seconds since 1970; default: SOURCE_DATE_EPOCH, else none");
    add_ideal_loop(verb, options->ideal_loop);
    verb.add_flag("--every-point", options->every_point,
                  "compute every point of a dense nonlinear map, interpolate none");
    verb.add_flag("--json", options->json, "machine-readable summary");
    verb.footer(
        "Example: stickslip sweep examples/02-ball-screw/spec-with-memory.toml -o out\n"
        "Exit codes: 0 done, 2 bad input, 3 interrupted (the same command continues), 4 too many points undecided.");
    verb.callback([options, &invocation] { invocation.exit_code = sweep(*options, invocation); });
}

}  // namespace stickslip
