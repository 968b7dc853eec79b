// stickslip report: draw the page of a finished sweep again.
#include "sweep/engine/results_file.h"
#include "sweep/engine/run_directory.h"
#include "sweep/files/bad_input.h"
#include "sweep/files/spec_file.h"
#include "sweep/program.h"
#include "sweep/report/summary.h"
#include "sweep/report/write_report.h"
#include "sweep/verbs/verbs.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

int report(const std::string& directory)
{
    if (!std::filesystem::exists(std::filesystem::path(directory) / run_files::results))
        throw BadInput(directory + ": holds no finished sweep (results.nc); make one with: stickslip sweep -o " +
                       directory);
    const ResultsFile results(std::filesystem::path(directory) / run_files::results);
    // the spec travels with its results, with its joint written out, so that the page needs no other file
    Spec spec = read_spec_text(results.attribute("spec"), directory + " (spec of results.nc)");
    choose_charts(spec);
    fmt::print("report:  {}\n", write_sweep_report(spec, summarise(spec, results), directory).string());
    return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Invocation& invocation)
{
    auto directory = std::make_shared<std::string>();
    auto* verb = app.add_subcommand("report", "Draw the report of a finished sweep again");
    verb->add_option("DIR", *directory, "directory of the sweep")->required();
    verb->footer("Example: stickslip report out");
    verb->callback([directory, &invocation] { invocation.exit_code = report(*directory); });
}

}  // namespace stickslip
