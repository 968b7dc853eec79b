// stickslip merge: journals of shards become one results.nc.
#include "sweep/engine/merge.h"
#include "analysis/results/text.h"
#include "sweep/engine/netcdf_file.h"
#include "sweep/engine/run_directory.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::vector<std::string> directories;
    std::string results;
    bool keep_journal = false;
};

int merge_journals(const Options& options)
{
    const std::vector<std::filesystem::path> directories(options.directories.begin(), options.directories.end());
    const std::filesystem::path results =
        options.results.empty() ? directories.front() / run_files::results : std::filesystem::path(options.results);
    try {
        if (const auto merged = merge(directories, results, options.keep_journal))
            fmt::print("{} merged in {:.2f} s\n", counted(merged->points, "point"), merged->seconds);
        else
            fmt::print("merged before: the results are whole\n");
    } catch (const NetcdfError& e) {
        say("stickslip: {}\nThe journals are safe: free some space and run the same command again.\n", e.what());
        return exit_interrupted;
    }
    fmt::print("results: {}\n", results.string());
    return exit_done;
}

}  // namespace

void add_merge(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("merge", "Merge the journals of shards into one results.nc");
    verb.add_option("DIR", options->directories, "directories of the shards")->required();
    verb.add_option("-o,--output", options->results, "results file; default: results.nc in the first directory");
    verb.add_flag("--keep-journal", options->keep_journal, "keep the journals, as large as the results");
    verb.footer("Example: stickslip merge out");
    verb.callback([options, &invocation] { invocation.exit_code = merge_journals(*options); });
}

}  // namespace stickslip
