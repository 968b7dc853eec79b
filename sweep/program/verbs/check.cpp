// stickslip check: do the boundaries still lie where they lay, and is the gap no worse than it was?
#include "analysis/stability/verdict.h"
#include "sweep/files/json/baseline_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/program/verbs/check_gap.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/left_out.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/shell_word.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/with_version.h"
#include "sweep/report/pages/check_report.h"
#include "sweep/report/write_report.h"
#include "sweep/words/loop_text.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

namespace stickslip {
namespace {

struct Options {
    std::string spec, baseline, junit, directory;
    std::vector<std::string> files;  ///< records and, last, the baseline
    std::string name;
    LogOptions how;
    std::string gap_tolerance = fmt::format("{:g}%", 100 * GapTolerance{}.gap);
    std::string number_tolerance = fmt::format("{:g}%", 100 * GapTolerance{}.number);
    int threads = 0;
    bool update = false, json = false, ideal_loop = false;
};

/// Nothing where the linear theory has no verdict.
std::optional<bool> is_design_stable(const Spec& spec)
{
    const auto verdict = linear_verdict(design_joint(spec));
    if (verdict.steady.reason != Reason::none || std::isnan(verdict.state_variable.spectral_abscissa)) return {};
    return verdict.state_variable.stable;
}

int check(const Options& options, const Invocation& invocation)
{
    Spec spec = read_spec(options.spec);
    const auto left_out = options.ideal_loop ? leave_loop_out(spec) : std::nullopt;
    const ThreadLimit limit(options.threads);
    const auto now = watched_boundaries(spec, parallel_for_each);
    if (now.empty()) throw BadInput(options.spec + ": no boundary lies within the axes: there is nothing to compare");
    if (options.update) {
        write_baseline(options.baseline, spec.title, now, numbers_of(spec), is_design_stable(spec));
        fmt::print("{}: {} boundaries written\n", options.baseline, now.size());
        return exit_done;
    }
    const auto deviations = compare(read_baseline(options.baseline), now);
    const auto stored_numbers = read_baseline_numbers(options.baseline);
    const auto changed =
        stored_numbers.empty() ? std::vector<ChangedNumber>{} : changed_numbers(stored_numbers, numbers_of(spec));
    std::size_t failed = 0, refined = 0;
    for (const auto& d : deviations) {
        const bool within = d.passes();
        failed += !within;
        refined += d.kind == Deviation::Kind::refined;
        const auto& shown = d.kind == Deviation::Kind::appeared ? d.now : d.stored;
        fmt::print("{} {:<80} {}\n", within ? "ok  " : "FAIL", shown.name(), describe(d));
    }
    const bool design_lost = read_baseline_design(options.baseline) == true && is_design_stable(spec) == false;
    if (design_lost) fmt::print("FAIL the design itself: was stable, is not\n");
    for (const auto& c : changed) fmt::print("changed since the baseline: {}\n", changed_text(spec, c));
    if (!options.junit.empty()) write_junit(options.junit, spec.title, deviations, design_lost);
    fmt::print("{} boundaries, {} out of tolerance, {} refined\n", deviations.size(), failed, refined);
    const auto loop = verdict_loop(design_joint(spec));
    if (const auto text = loop_text(loop); !text.empty()) fmt::print("{}\n", text.substr(1));
    if (!options.directory.empty()) {
        auto report = with_version(check_report(spec, deviations, changed, loop, design_lost, invocation.command));
        if (left_out) tell_left_out(*left_out, left_out->growth < 0, report);
        fmt::print("report: {}\n", write_report(report, options.directory).string());
    }
    if (failed || design_lost)
        fmt::print("If the change is wanted: stickslip check {} {} --update\n", shell_word(options.spec),
                   shell_word(options.baseline));
    return failed || design_lost ? exit_not_met : exit_done;
}

int check_files(Options options, const Invocation& invocation)
{
    GapTolerance tolerance;
    tolerance.gap = share_in(options.gap_tolerance).value();
    tolerance.number = share_in(options.number_tolerance).value();
    options.baseline = options.files.back();
    options.files.pop_back();
    if (!options.files.empty() && options.ideal_loop)
        throw BadInput("--ideal-loop: is only for a check of boundaries; records are of the loop as it is");
    if (!options.files.empty())
        return check_gap({options.spec, options.baseline, options.junit, options.directory, options.files, options.name,
                          options.how, tolerance, options.threads, options.update, options.json},
                         invocation);
    if (options.json) throw BadInput("--json: is only for a check of records; one of boundaries writes --junit and -o");
    return check(options, invocation);
}

}  // namespace

void add_check(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "check",
        "Compare boundary locations, or a joint's gap to its records, with a baseline; exit 1 on a regression");
    verb.add_option("SPEC", options->spec, "sweep spec, or the joint of the records, TOML")->required();
    verb.add_option("FILES", options->files, "for a gap: records or folders of records; last: the baseline, JSON")
        ->required();
    verb.add_flag("--update", options->update, "write the baseline instead of comparing");
    verb.add_option("--junit", options->junit, "also write the outcome as JUnit XML to this file");
    verb.add_option("-o,--output", options->directory,
                    "directory for report.html with old and new curves, or for the diagnosis of the records");
    add_threads(verb, options->threads, "number of threads; 0: all cores")->capture_default_str();
    verb.add_flag("--ideal-loop", options->ideal_loop,
                  "of boundaries: the paper's loop, no sampling, dead time, filter, lag or integral");
    verb.add_flag("--json", options->json, "print the outcome of a gap check as JSON");
    verb.add_option("--gap-tolerance", options->gap_tolerance, "largest relative growth of the gap: 0.1 or 10%")
        ->check(not_negative_share())
        ->capture_default_str();
    verb.add_option("--number-tolerance", options->number_tolerance,
                    "largest relative change of a parameter, if it also exceeds 5 standard errors")
        ->check(not_negative_share())
        ->capture_default_str();
    verb.add_option("--joint", options->name, "name of the joint in logs of several");
    add_log_options(verb, options->how);
    verb.footer(
        "Example: stickslip check examples/02-ball-screw/spec-with-memory.toml examples/02-ball-screw/baseline.json\n"
        "Example: stickslip check joint.toml records/ baseline-gap.json --update\n"
        "Example: stickslip check joint.toml records/ baseline-gap.json --junit gap.xml\n"
        "Watched: both linear boundaries, V_min where control.V0 is an axis, folds where [nonlinear] is enabled, "
        "outcomes where its disturbance has a size. With records: the gap and what its cause leaves, the causes, and "
        "their numbers.\n"
        "Exit codes: 0 all within tolerance or refined, 1 the design was stable and is not, a boundary moved, "
        "vanished, appeared, changed its stable "
        "side or is located more coarsely, or the gap is new, has grown, has another cause or another size of it; 2 "
        "bad "
        "input, 3 interrupted, 4 insufficient records.");
    verb.callback([options, &invocation] {
        if (options->files.size() > 1) catch_interrupts(invocation);  // a check of boundaries ends where it stands
        invocation.exit_code = check_files(*options, invocation);
    });
}

}  // namespace stickslip
