// stickslip compare: two diagnoses of one joint; is the gap new, which parameter moved, by how many standard errors.
#include "sweep/engine/build.h"
#include "sweep/files/json/comparison_json.h"
#include "sweep/files/json/diagnosis_file.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/program/verbs/diagnosis_verbs.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/report/pages/timeline_report.h"
#include "sweep/report/write_report.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string before, after, directory;
    bool json = false;
};

int compare_verb(const Options& options, const Invocation& invocation)
{
    const auto comparison = compare_diagnoses(read_diagnosis(options.before), read_diagnosis(options.after));
    const auto json = comparison_json(comparison).dump(2) + "\n";
    if (!options.directory.empty()) {
        write_whole(std::filesystem::path(options.directory) / "comparison.json", json);
        write_report(comparison_report(comparison, {{"version", program_version()}, {"command", invocation.command}}),
                     options.directory);
    }
    if (options.json) {
        fmt::print("{}", json);
        return exit_done;
    }
    print_sentence(comparison_sentence(comparison));
    for (const auto& change : comparison.numbers)
        if (is_reported(change, comparison)) fmt::print("  {}\n", plain_text(change_text(change)));
    if (!options.directory.empty())
        fmt::print("report: {}\n", (std::filesystem::path(options.directory) / "report.html").string());
    return exit_done;
}

}  // namespace

void add_compare(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "compare", "Compare two diagnoses: is the gap new, which parameter moved, by how many standard errors");
    verb.add_option("BEFORE", options->before, "diagnosis.json, or the folder that diagnose wrote")->required();
    verb.add_option("AFTER", options->after, "the same for the later records")->required();
    verb.add_option("-o,--output", options->directory, "directory for comparison.json and report.html");
    verb.add_flag("--json", options->json, "print comparison.json");
    verb.footer(
        "Example: stickslip compare runs/2026-03-01 runs/2026-04-01 -o compared\n"
        "Exit codes: 0 compared, 2 bad input.");
    verb.callback([options, &invocation] { invocation.exit_code = compare_verb(*options, invocation); });
}

}  // namespace stickslip
