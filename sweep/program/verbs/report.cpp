// stickslip report: draw the page of a finished sweep again, or of what changed between two.
#include "analysis/joint/parameters.h"
#include "analysis/loop/loop_use.h"
#include "sweep/engine/results_file.h"
#include "sweep/engine/run_directory.h"
#include "sweep/files/json/sweep_answer_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/held_answer.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/timestamp.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/compare_report.h"
#include "sweep/report/pages/stability_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/left_out_loop.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::vector<std::string> directories;
    std::string output, timestamp;  // no output: beside the results, and of two sweeps in comparison/
};

ResultsFile finished_sweep(const std::string& directory)
{
    const auto file = std::filesystem::path(directory) / run_files::results;
    if (!std::filesystem::exists(file)) throw BadInput(instead_of_a_sweep(directory));
    return ResultsFile(file);
}

/// The stored spec is as the user wrote it: of a sweep with --ideal-loop, whose results are of a joint without its
/// loop, it gets that joint.
std::optional<LeftOutLoop> take_loop_of(const ResultsFile& results, Spec& spec)
{
    const Joint ideal = with_ideal_loop(spec.joint);
    const auto computed = results.attribute("joint");
    if (canonical_text(spec.joint) == computed || canonical_text(ideal) != computed) return std::nullopt;
    auto left_out = left_out_loop(design_joint(spec));
    spec.joint = ideal;
    return left_out;
}

/// A finished sweep. The spec travels with its results, with its joint written out, so that no other file is needed.
/// `charts` are those to show; empty: the sweep's own.
ComparedRun read_run(const std::string& directory, const ReportSpec* charts, const std::string& date)
{
    const auto results = finished_sweep(directory);
    ComparedRun run{directory, read_spec_text(results.attribute("spec"), directory + " (spec of results.nc)"), {}};
    take_loop_of(results, run.spec);
    choose_charts(run.spec);
    if (charts) {
        const auto has = [&](const std::string& path) {
            for (const auto& axis : run.spec.axes)
                if (axis.path == path) return true;
            return false;
        };
        run.spec.report.charts.clear();
        for (const auto& chart : charts->charts)
            if (has(chart[0]) && has(chart[1])) run.spec.report.charts.push_back(chart);
    }
    run.summary = summarise(run.spec, results);
    if (!date.empty()) run.summary.provenance.emplace_back("drawn", date);
    return run;
}

/// From what is stored beside the results; where nothing is, as after a merge, it is computed and stored first.
int draw_again(const std::string& directory, const std::string& output, const std::string& date)
{
    const auto results = finished_sweep(directory);
    auto answer = read_sweep_answer(directory, results.attribute("plan_id"));
    auto spec = read_spec_text(answer ? answer->spec : results.attribute("spec"), directory + " (spec of the sweep)");
    const auto left_out = take_loop_of(results, spec);
    choose_charts(spec);
    auto summary = summarise(spec, results);
    if (!answer || !fits(*answer, summary)) {
        answer = answer_sweep(spec, summary);
        answer->spec = results.attribute("spec");
        answer->left_out = left_out;
        write_sweep_answer(*answer, directory);
    }
    if (!date.empty()) summary.provenance.emplace_back("drawn", date);
    const auto report = stability_report(spec, summary, *answer);
    fmt::print("{}", terminal_summary(report));
    fmt::print("report:  {}\n", write_sweep_report(report, spec, answer->spec, output).string());
    return exit_done;
}

int compare(const Options& options, const std::string& date)
{
    auto before = read_run(options.directories[0], nullptr, date);
    auto after = read_run(options.directories[1], &before.spec.report, date);
    const auto report = compare_report(compare_sweeps(std::move(before), std::move(after)));
    fmt::print("{}", terminal_summary(report));
    const auto output = options.output.empty() ? "comparison" : options.output;
    fmt::print("report:  {}\n", write_report(report, output).string());
    return exit_done;
}

int report(const Options& options)
{
    const auto date = timestamp(options.timestamp);
    if (options.directories.size() > 1) return compare(options, date);
    const auto& directory = options.directories[0];
    return draw_again(directory, options.output.empty() ? directory : options.output, date);
}

}  // namespace

void add_report(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("report", "Draw the report of a finished sweep again, or compare two sweeps");
    verb.add_option("DIR", options->directories, "directory of the sweep; two of them: what changed from A to B")
        ->required()
        ->expected(1, 2);
    verb.add_option("-o,--output", options->output, "directory of the page; default: DIR, of two sweeps: comparison");
    verb.add_option("--timestamp", options->timestamp,
                    "date on the page: now, or seconds since 1970; default: SOURCE_DATE_EPOCH, else none");
    verb.footer("Examples: stickslip report out\n          stickslip report before after -o comparison");
    verb.callback([options, &invocation] { invocation.exit_code = report(*options); });
}

}  // namespace stickslip
