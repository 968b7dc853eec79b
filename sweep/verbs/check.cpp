// stickslip check: do the boundaries still lie where they lay?
#include "sweep/check/baseline_file.h"
#include "sweep/files/bad_input.h"
#include "sweep/files/spec_file.h"
#include "sweep/program.h"
#include "sweep/verbs/verbs.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string spec, baseline, junit;
    bool update = false;
};

int check(const Options& options)
{
    const Spec spec = read_spec(options.spec);
    const auto now = watched_boundaries(spec);
    if (now.empty()) throw BadInput(options.spec + ": no boundary lies within the axes: a check would compare nothing");
    if (options.update) {
        write_baseline(options.baseline, spec.title, now);
        fmt::print("{}: {} boundaries written\n", options.baseline, now.size());
        return exit_done;
    }
    const auto deviations = compare(read_baseline(options.baseline), now);
    std::size_t failed = 0;
    for (const auto& d : deviations) {
        const bool within = d.kind == Deviation::Kind::within;
        failed += !within;
        const auto& shown = d.kind == Deviation::Kind::appeared ? d.now : d.stored;
        fmt::print("{} {:<80} {}\n", within ? "ok  " : "FAIL", shown.name(), describe(d));
    }
    if (!options.junit.empty()) write_junit(options.junit, spec.title, deviations);
    fmt::print("{} boundaries, {} out of tolerance\n", deviations.size(), failed);
    if (failed) fmt::print("If the change is wanted: stickslip check {} {} --update\n", options.spec, options.baseline);
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
    verb->footer(
        "Example: stickslip check examples/02-ball-screw/spec-with-memory.toml examples/02-ball-screw/baseline.json");
    verb->callback([options, &invocation] { invocation.exit_code = check(*options); });
}

}  // namespace stickslip
