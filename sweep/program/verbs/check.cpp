// stickslip check: do the boundaries still lie where they lay?
#include "sweep/files/json/baseline_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/shell_word.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/check_report.h"
#include "sweep/report/pages/write_report.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string spec, baseline, junit, directory;
    int threads = 0;
    bool update = false;
};

int check(const Options& options, const Invocation& invocation)
{
    const Spec spec = read_spec(options.spec);
    const ThreadLimit limit(options.threads);
    const auto now = watched_boundaries(spec, parallel_for_each);
    if (now.empty()) throw BadInput(options.spec + ": no boundary lies within the axes: a check would compare nothing");
    if (options.update) {
        write_baseline(options.baseline, spec.title, now, numbers_of(spec));
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
    for (const auto& c : changed) fmt::print("changed since the baseline: {}\n", changed_text(spec, c));
    if (!options.junit.empty()) write_junit(options.junit, spec.title, deviations);
    fmt::print("{} boundaries, {} out of tolerance, {} refined\n", deviations.size(), failed, refined);
    if (!options.directory.empty())
        fmt::print(
            "report: {}\n",
            write_report(check_report(spec, deviations, changed, invocation.command), options.directory).string());
    if (failed)
        fmt::print("If the change is wanted: stickslip check {} {} --update\n", shell_word(options.spec),
                   shell_word(options.baseline));
    return failed ? exit_check_failed : exit_done;
}

}  // namespace

void add_check(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* verb =
        app.add_subcommand("check", "Compare boundary locations with a stored baseline; exit 1 on a regression");
    verb->add_option("SPEC", options->spec, "sweep spec, TOML")->required();
    verb->add_option("BASELINE", options->baseline, "baseline, JSON")->required();
    verb->add_flag("--update", options->update, "write the baseline instead of comparing");
    verb->add_option("--junit", options->junit, "also write the outcome as JUnit XML to this file");
    verb->add_option("-o,--output", options->directory, "write a small report.html with old and new curves here");
    verb->add_option("--threads", options->threads, "0: all cores")->capture_default_str();
    verb->footer(
        "Example: stickslip check examples/02-ball-screw/spec-with-memory.toml examples/02-ball-screw/baseline.json\n"
        "Watched: both linear boundaries, V_min where control.V0 is an axis, folds where [nonlinear] is enabled, "
        "outcomes where its disturbance has a size.\n"
        "Exit codes: 0 all within tolerance or refined, 1 a boundary moved, vanished, appeared, changed its stable "
        "side or is located more coarsely, 2 bad input.");
    verb->callback([options, &invocation] { invocation.exit_code = check(*options, invocation); });
}

}  // namespace stickslip
