// stickslip diagnose: where the sim-to-real gap of a joint lies, what causes it, how far it shrinks.
#include "analysis/diagnosis/diagnose.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/diagnosis_json.h"
#include "sweep/files/records/joint_log.h"
#include "sweep/files/records/outcome_file.h"
#include "sweep/files/robots/robot_joints.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/diagnose_joint.h"
#include "sweep/program/verbs/diagnose_robot.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/gather_records.h"
#include "sweep/program/verbs/guarantee_option.h"
#include "sweep/program/verbs/log_options.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/diagnosis_report.h"
#include "sweep/report/pages/outcome_report.h"
#include "sweep/report/write_report.h"
#include "sweep/words/diagnosis_first_screen.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/guarantee_text.h"
#include "sweep/words/outcome_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/refusal_text.h"
#include "sweep/words/signature_text.h"

#include <fmt/format.h>
#include <optional>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

namespace stickslip {
namespace {

struct Options {
    std::string joint, directory = "diagnosis";
    std::vector<std::string> records, names;
    LogOptions how;
    GuaranteeOption guarantee;
    int threads = 0;
    bool json = false, no_report = false, all_joints = false;
};

/// The settings that would tell two laws apart, in the columns of the table.
void write_next_outcome(const std::filesystem::path& file, const gap::OutcomeAnswer& answer)
{
    std::string header, row;
    for (std::size_t k = 0; k < answer.next.settings.size(); ++k) {
        header += answer.outcomes.table.paths[k] + ",";
        row += fmt::format("{},", answer.next.settings[k]);
    }
    write_whole(file, header + "outcome\n" + row + "\n");
}

/// A table of measured outcomes in place of records.
int diagnose_outcomes(const Options& options, const Joint& joint, const Invocation& invocation)
{
    std::vector<std::string> warnings;
    const auto table = read_outcomes(options.records.front(), joint, warnings);
    const auto directory = answer_folder(options.directory);
    std::optional<gap::OutcomeAnswer> found;
    try {
        StageLine line;
        found = gap::explain(joint, table, line.counted(parallel_for_each), line.listener(), gap::rival_laws(), [&] {
            if (invocation.interrupted) throw gap::Interrupted();
        });
    } catch (const std::invalid_argument& e) {
        throw BadInput(refusal_text(e));
    } catch (const gap::Interrupted&) {
        say("interrupted before the laws were ranked: no output\n");
        return exit_interrupted;
    }
    gap::OutcomeAnswer& answer = *found;
    Diagnosis& d = answer.diagnosis;
    std::vector<Note> of_reader;
    for (const auto& text : warnings) of_reader.push_back({.text = text});
    d.notes.insert(d.notes.begin(), of_reader.begin(), of_reader.end());
    const auto next = plain_text(next_outcome_text(answer));
    remove_earlier(directory);
    auto json = diagnosis_json(d, {own_windows(joint, d.usual_speed), own_windows(answer.after, d.usual_speed)});
    json["next_experiment"]["description"] = next;
    if (!answer.next.settings.empty()) {
        json["next_experiment"]["file"] = "next-outcome.csv";
        write_next_outcome(directory / "next-outcome.csv", answer);
    }
    write_whole(directory / "diagnosis.json", json.dump(2) + "\n");
    if (!options.no_report) {
        const auto maps = answer.laws.empty() ? OutcomeMaps{} : outcome_maps(answer, joint);
        const auto moved =
            d.verdict == Verdict::gap ? moved_boundary(joint, answer.after, d.usual_speed) : MovedBoundary{};
        write_report(outcome_report(answer, maps, joint, moved,
                                    {{"version", program_version()}, {"command", invocation.command}}),
                     directory);
    }
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
        return exit_code_of(d, false);
    }
    print_sentence(outcome_sentence(answer));
    for (const auto& reason : d.reasons) fmt::print("  {}\n", note_text(reason));
    for (const auto& f : answer.laws)
        fmt::print("  {:<16} {:<19} probability {:.3f}  misjudges {} of {} held-out rows\n", f.rival->law,
                   effect_words(f.rival->effect), f.posterior, f.misjudged, answer.outcomes.size());
    if (!next.empty()) fmt::print("next: {}\n", next);
    fmt::print("diagnosis: {}\n", (directory / "diagnosis.json").string());
    if (!options.no_report) fmt::print("report:    {}\n", (directory / "report.html").string());
    return exit_code_of(d, false);
}

void print_answer(const JointDiagnosis& found, const GatheredRecords& given)
{
    const Diagnosis& d = found.diagnosis;
    print_sentence(diagnosis_sentence(d));
    for (const auto& reason : d.reasons) fmt::print("  {}\n", note_text(reason));
    if (!found.contradicted)
        for (const auto& warning : given.warnings) fmt::print("  {}\n", note_text(warning));
    for (const auto& cause : d.effects)
        fmt::print("  {:<44} probability {:.3f}  misfit {:.4g}\n", together(cause.names), cause.probability,
                   cause.misfit);
    constexpr double visible = 5e-4;
    if (const double none = probability_of_none(d); none > visible)
        fmt::print("  {:<44} probability {:.3f}\n", "none of these", none);
    if (d.set) fmt::print("  {}\n  {}\n", cause_set_text(*d.set), promise_text(*d.set));
    if (!d.effects.empty())
        for (const auto& value : d.effects[0].values)
            fmt::print("  {:<44} {}\n", sheet_label(value.key), value_text(value));
}

int diagnose(const Options& options, const Invocation& invocation)
{
    if (options.all_joints || is_robot(options.joint)) {
        if (!options.all_joints && options.names.empty())
            throw BadInput(options.joint + ": has several joints, expected --all-joints, or --joint NAME");
        if (options.guarantee.asked()) throw BadInput("--guarantee: is of one joint at a time");
        refuse_twice(options.records);
        return diagnose_robot({options.joint, options.directory, options.records, options.names, options.how,
                               options.threads, options.json, options.no_report},
                              invocation);
    }
    if (options.names.size() > 1)
        throw BadInput("--joint: names " + std::to_string(options.names.size()) + " joints, but " + options.joint +
                       " is the file of one");
    const Joint joint = read_joint(options.joint);
    const ThreadLimit limit(options.threads);
    for (const auto& file : options.records) {
        if (is_foreign_log(file) || !is_outcome_file(file)) continue;
        if (options.records.size() > 1)
            throw BadInput(file + ": is a table of outcomes; it is diagnosed alone, without records or other tables");
        if (options.guarantee.asked())
            throw BadInput(file + ": is a table of outcomes, for which there is no --guarantee");
        return diagnose_outcomes(options, joint, invocation);
    }
    const auto given = gather_records(
        options.records, {options.joint, options.names.empty() ? "" : options.names.front(), options.how}, joint);
    const auto promised = guarantee_for(options.guarantee, joint, given.records);
    const auto directory = answer_folder(options.directory);
    require_fitted(joint, given, options.joint);
    auto found = [&] {
        StageLine line;
        return diagnose_joint(joint, given, invocation, line);
    }();
    if (promised) add_set(*promised, found);
    const Diagnosis& d = found.diagnosis;
    // printed before it is written: a disk that has filled up meanwhile does not take the answer along
    if (options.json)
        fmt::print("{}", joint_diagnosis_json(found));
    else
        print_answer(found, given);
    const bool whole = write_joint_diagnosis(found, directory, invocation, !options.no_report);
    if (!options.json) {
        fmt::print("diagnosis: {}\n", (directory / "diagnosis.json").string());
        if (!options.no_report) fmt::print("report:    {}\n", (directory / "report.html").string());
    }
    if (invocation.interrupted && !d.interrupted && !found.contradicted) {
        say("interrupted: the diagnosis is written{}\n", whole ? "" : ", its page lacks gains");
        return exit_interrupted;
    }
    return exit_code_of(d, found.contradicted);
}

}  // namespace

void add_diagnose(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb =
        line.add_verb("diagnose", "Diagnose the gap between a joint and its records: where it is and what causes it");
    verb.add_option("JOINT", options->joint,
                    "nominal joint, TOML; or robot.toml with [joints], or a folder of joint files")
        ->required();
    verb.add_option("RECORD", options->records,
                    "records, CSV or .csv.gz, SI units unless the [record] table gives others, or logs that convert "
                    "reads; or one table of outcomes: k_p, k_v, V0, outcome (stable | stick-slip), amplitude")
        ->required();
    verb.add_flag("--all-joints", options->all_joints, "every joint of a robot, and a page of joints and causes");
    verb.add_option("--joint", options->names, "name of the joint in logs of several; of a robot: only this one")
        ->one_value();
    add_log_options(verb, options->how);
    options->guarantee.add_to(verb);
    verb.add_option("-o,--output", options->directory,
                    "directory for diagnosis.json and report.html; of a robot for robot.json, robot.html and a folder "
                    "for each joint");
    add_threads(verb, options->threads, "number of threads; 0: all cores; the answer does not depend on it");
    verb.add_flag("--json", options->json, "print diagnosis.json");
    verb.add_flag("--no-report", options->no_report, "do not write the page");
    verb.footer(
        "Example: stickslip diagnose joint.toml slow.csv.gz steps.csv.gz -o diagnosis\n"
        "Example: stickslip diagnose joint.toml outcomes.csv -o which-law\n"
        "Example: stickslip diagnose robot.toml run.mcap --all-joints -o arm\n"
        "Example: stickslip diagnose joint.toml slow.csv.gz --guarantee 0.95 --calibration calibration.json\n"
        "Exit codes: 0 answered (gap, no-gap, unknown), 2 bad input (suspected units included), 3 interrupted, 4 too "
        "little "
        "data.");
    verb.callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = diagnose(*options, invocation);
    });
}

}  // namespace stickslip
