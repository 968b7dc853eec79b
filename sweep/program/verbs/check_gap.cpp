#include "sweep/program/verbs/check_gap.h"

#include "sweep/files/json/comparison_json.h"
#include "sweep/files/json/diagnosis_file.h"
#include "sweep/files/json/diagnosis_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/changed_lines.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/gather_records.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/shell_word.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace stickslip {
namespace {

/// Folders stand for the records in them, by name; not one that is itself a log.
std::vector<std::string> files_in(const std::vector<std::string>& given)
{
    std::vector<std::string> files;
    for (const auto& path : given) {
        if (!std::filesystem::is_directory(path) || is_folder_of_a_log(path)) {
            files.push_back(path);
            continue;
        }
        std::vector<std::string> inside;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            if (entry.is_regular_file() && (is_table(entry.path()) || is_foreign_log(entry.path())))
                inside.push_back(entry.path().string());
        if (inside.empty())
            throw BadInput(path + ": holds no records, expected .csv, .csv.gz or a log that convert reads");
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

void say(const GapCheck& check, const GapCheckQuestion& question)
{
    for (const auto& r : check.regressions) fmt::print("FAIL {}\n", plain_text(regression_text(r, check.comparison)));
    if (check.passes()) fmt::print("ok   {}\n", outcome_words(check.comparison.after));
    print_sentence(comparison_sentence(check.comparison));
    if (!check.changed_joint.empty()) fmt::print("the joint file has changed since the baseline:\n");
    for (const auto& line : check.changed_joint) fmt::print("  {}\n", line);
    if (check.passes()) return;
    std::string records;
    for (const auto& r : question.records) records += shell_word(r) + " ";
    fmt::print("If the change is wanted: stickslip check {} {}{} --update\n", shell_word(question.joint), records,
               shell_word(question.baseline));
}

int exit_code_of(const GapCheck& check)
{
    const auto& now = check.comparison.after;
    if (now.interrupted) return exit_interrupted;
    if (now.verdict == Verdict::insufficient_data) return exit_insufficient;
    return check.passes() ? exit_done : exit_not_met;
}

}  // namespace

int check_gap(const GapCheckQuestion& question, const Invocation& invocation)
{
    const Joint joint = read_joint(question.joint);
    const auto baseline = question.update ? GapBaseline{} : read_gap_baseline(question.baseline);
    const ThreadLimit limit(question.threads);
    const auto given = gather_records(files_in(question.records), {question.joint, question.name, question.how}, joint);
    if (!question.directory.empty()) answer_folder(question.directory);
    const auto found = [&] {
        StageLine line;
        return diagnose_joint(joint, given, invocation, line);
    }();
    if (found.contradicted) {
        std::vector<std::string> reasons;
        for (const auto& reason : found.diagnosis.reasons) reasons.push_back(note_text(reason));
        throw BadInput(reasons);
    }
    const auto now = diagnosis_json(found.diagnosis, found.windows);
    if (!question.directory.empty()) write_joint_diagnosis(found, question.directory, invocation, true);
    if (question.update) {
        const auto facts = diagnosis_facts(now, question.baseline);
        if (facts.interrupted) return exit_interrupted;  // half an answer is no baseline
        if (!facts.answered())
            throw BadInput(question.joint + ": the records are not sufficient for a baseline: " +
                           (found.diagnosis.reasons.empty() ? "" : note_text(found.diagnosis.reasons.front())));
        write_gap_baseline(question.baseline, joint_text(joint), now.dump());
        fmt::print("{}: {} written\n", question.baseline, outcome_words(facts));
        return exit_done;
    }
    GapCheck check;
    check.tolerance = question.tolerance;
    check.comparison = compare_diagnoses(baseline.diagnosis, diagnosis_facts(now, "these records"));
    check.regressions = gap_regressions(check.comparison, check.tolerance);
    check.changed_joint = lines_of(changed_lines(baseline.joint, joint_text(joint)));
    const auto json = gap_check_json(check).dump(2) + "\n";
    if (!question.directory.empty()) write_whole(std::filesystem::path(question.directory) / "gap-check.json", json);
    if (!question.junit.empty()) write_gap_junit(question.junit, question.joint, check);
    if (question.json)
        fmt::print("{}", json);
    else
        say(check, question);
    return exit_code_of(check);
}

}  // namespace stickslip
