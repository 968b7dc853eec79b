// stickslip timeline: the diagnoses of one joint in the order of their dates, on one page.
#include "sweep/engine/build.h"
#include "sweep/files/json/comparison_json.h"
#include "sweep/files/json/diagnosis_file.h"
#include "sweep/files/json/timeline_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/program/verbs/diagnose_joint.h"
#include "sweep/program/verbs/diagnosis_verbs.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/report/pages/timeline_report.h"
#include "sweep/report/write_linked_report.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/timeline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> places;
    std::string joint, directory = "timeline";
    bool json = false, no_report = false;
};

/// diagnosis.json of the joint in a folder, or nothing.
fs::path answer_in(const fs::path& folder, const std::string& joint)
{
    const auto file = (joint.empty() ? folder : folder / joint) / "diagnosis.json";
    return fs::exists(file) ? file : fs::path();
}

/// A run, or a folder of runs.
std::vector<fs::path> answers_at(const fs::path& place, const std::string& joint)
{
    if (fs::is_regular_file(place)) return {place};
    if (const auto own = answer_in(place, joint); !own.empty()) return {own};
    std::vector<fs::path> found;
    if (fs::is_directory(place))
        for (const auto& entry : fs::directory_iterator(place))
            if (const auto file = answer_in(entry.path(), joint); !file.empty()) found.push_back(file);
    if (found.empty())
        throw BadInput(place.string() + ": holds no diagnosis.json" + (joint.empty() ? "" : " of joint " + joint) +
                       ", nor do its folders; expected what `stickslip diagnose -o` or `check -o` wrote" +
                       (joint.empty() ? ", of a robot with --joint NAME" : ""));
    return found;
}

/// From the innermost part of the path that has one.
Timestamp date_of(const fs::path& file)
{
    for (auto path = fs::absolute(file); path.has_relative_path(); path = path.parent_path())
        if (const auto date = date_in(path.filename().string())) return *date;
    throw BadInput(file.string() +
                   ": no part of this path has a date; expected a folder such as 2026-03-01 or "
                   "elbow-2026-03-01T14-30");
}

Timeline read_timeline(const Options& options)
{
    std::vector<fs::path> files;
    for (const auto& place : options.places)
        for (const auto& file : answers_at(place, options.joint)) files.push_back(fs::weakly_canonical(file));
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    std::vector<DatedDiagnosis> runs;
    for (const auto& file : files) {
        const auto page = file.parent_path() / "report.html";
        const auto from = fs::weakly_canonical(fs::absolute(options.directory));  // it need not exist yet
        runs.push_back({date_of(file), read_diagnosis(file),
                        fs::exists(page) ? page.lexically_relative(from).generic_string() : std::string()});
    }
    return timeline_of(options.joint, std::move(runs));
}

int timeline_verb(const Options& options, const Invocation& invocation)
{
    if (options.directory.empty()) throw BadInput("--output: is empty, expected a folder");
    const auto timeline = read_timeline(options);
    const fs::path directory = options.directory;
    const auto json = timeline_json(timeline).dump(2) + "\n";
    write_whole(directory / "timeline.json", json);
    if (!options.no_report) {
        const auto page = timeline_report(timeline, {{"version", program_version()}, {"command", invocation.command}});
        write_linked_report(page.report, directory, page.marks);
    }
    if (options.json) {
        fmt::print("{}", json);
        return exit_done;
    }
    print_sentence(timeline_sentence(timeline));
    for (const auto& run : timeline.runs) fmt::print("  {}  {}\n", date_text(run.at), outcome_words(run.facts));
    fmt::print("timeline: {}\n", (directory / "timeline.json").string());
    if (!options.no_report) fmt::print("report:   {}\n", (directory / "report.html").string());
    return exit_done;
}

}  // namespace

void add_timeline(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("timeline", "Draw the dated diagnoses of one joint on one page: gap, causes, numbers");
    verb.add_option("RUN", options->places,
                    "folders written by diagnose or check, or one folder that contains them; each name contains a date")
        ->required();
    verb.add_option("--joint", options->joint, "name of the joint, for diagnoses of a robot");
    verb.add_option("-o,--output", options->directory, "directory for timeline.json and report.html")
        ->capture_default_str();
    verb.add_flag("--json", options->json, "print timeline.json");
    verb.add_flag("--no-report", options->no_report, "do not write the page");
    verb.footer(
        "Example: stickslip timeline runs -o elbow-over-time\n"
        "Example: stickslip timeline arm-2026-03-01 arm-2026-04-01 --joint elbow\n"
        "Exit codes: 0 done, 2 bad input.");
    verb.callback([options, &invocation] { invocation.exit_code = timeline_verb(*options, invocation); });
}

}  // namespace stickslip
