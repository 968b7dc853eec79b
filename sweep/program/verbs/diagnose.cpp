// stickslip diagnose: where the sim-to-real gap of a joint lies, what causes it, how far it shrinks.
#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/rig/rig.h"
#include "analysis/joint/parameters.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/diagnosis_json.h"
#include "sweep/files/records/outcome_file.h"
#include "sweep/files/records/record_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/changed_lines.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/diagnosis_report.h"
#include "sweep/report/pages/outcome_report.h"
#include "sweep/report/pages/write_report.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/verdict_text.h"

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
    std::vector<std::string> records;
    int threads = 0;
    bool json = false, no_report = false;
};

void write_experiment(const std::filesystem::path& file, const NextExperiment& experiment)
{
    std::string text = "time,reference_position\n";
    for (std::size_t k = 0; k < experiment.time.size(); ++k)
        text += fmt::format("{},{}\n", experiment.time[k], experiment.reference[k]);
    write_whole(file, text);
}

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

/// The folder of the answer, tried before the work and not after it.
std::filesystem::path output_folder(const Options& options)
{
    if (options.directory.empty()) throw BadInput("--output: is empty, allowed is a folder");
    const std::filesystem::path probe = std::filesystem::path(options.directory) / "diagnosis.json.probe";
    write_whole(probe, "");
    std::filesystem::remove(probe);
    return options.directory;
}

/// What an earlier answer left there would contradict this one.
void remove_earlier(const std::filesystem::path& directory)
{
    for (const char* name : {"report.html", "next-experiment.csv", "next-outcome.csv", "corrected-joint.toml"})
        std::filesystem::remove(directory / name);
}

/// The same file twice would be held out of a fit to itself.
void refuse_twice(const std::vector<std::string>& files)
{
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            std::error_code missing;  // reading says so
            if (std::filesystem::equivalent(files[i], files[j], missing))
                throw BadInput(files[i] + ": is given twice, allowed is every record once");
        }
}

/// Two records of one name are told apart by their folders.
void name_by_path(RecordReading& reading, const std::string& file, const std::vector<std::string>& files)
{
    const std::string name = reading.record.name;
    const auto same = [&](const std::string& other) { return std::filesystem::path(other).filename() == name; };
    if (std::count_if(files.begin(), files.end(), same) < 2) return;
    reading.record.name = file;
    for (auto* texts : {&reading.warnings, &reading.contradictions})
        for (auto& text : *texts)
            if (text.starts_with(name + ":")) text.replace(0, name.size(), file);
}

/// Signals that the simulation is driven by or compared with.
bool needs_every_value(const std::string& signal)
{
    for (const char* other : {"temperature", "torque_enable", "link_position", "normal_load"})
        if (signal == other) return false;
    return true;
}

/// What the caller is told: INTERFACE of `diagnose`.
int exit_code_of(const Diagnosis& d, bool contradicted)
{
    if (contradicted) return exit_bad_input;
    if (d.interrupted) return exit_interrupted;
    return d.verdict == Verdict::insufficient_data ? exit_insufficient : exit_done;
}

/// The same tasks, until somebody asks to stop: those not yet begun are then left out, and Interrupted is thrown.
ParallelFor until_interrupted(const std::atomic<bool>& interrupted, ParallelFor run)
{
    return [&interrupted, run = std::move(run)](std::size_t n, const std::function<void(std::size_t)>& task) {
        run(n, [&](std::size_t i) {
            if (!interrupted) task(i);
        });
        if (interrupted) throw gap::Interrupted();
    };
}

/// The joint with everything that was found in it, as the program reads joints; empty where nothing was named.
std::string corrected_joint(const Diagnosis& d, const Joint& joint, const Joint& after)
{
    if (d.verdict != Verdict::gap || d.effects.empty() || joint_text(after) == joint_text(joint)) return "";
    std::string head = "# The documented joint with what the diagnosis found:";
    for (const auto& name : d.effects.front().names) head += " " + name;
    for (const auto& [name, value, error, unit] : d.effects.front().parameters)
        head += fmt::format("\n#   {} = {:.6g}{} {}", name, value,
                            std::isfinite(error) ? fmt::format(" +- {:.2g}", error) : "", unit == "1" ? "" : unit);
    return head + "\n" + joint_text(after);
}

/// What the page offers to take along.
std::vector<Snippet> corrections(const std::string& corrected, const Joint& joint, const Joint& after)
{
    if (corrected.empty()) return {};
    return {{"To put into the joint file: what the diagnosis changes in it, documented values behind #",
             changed_lines(joint_text(joint), joint_text(after)), ""},
            {"The whole corrected joint file", corrected, "corrected-joint.toml"}};
}

/// A table of measured outcomes in place of records.
int diagnose_outcomes(const Options& options, const Joint& joint, const Invocation& invocation)
{
    std::vector<std::string> warnings;
    const auto table = read_outcomes(options.records.front(), joint, warnings);
    const auto directory = output_folder(options);
    std::optional<gap::OutcomeAnswer> found;
    try {
        StageLine line;
        found = gap::explain(joint, table, line.counted(parallel_for_each), line.listener(), gap::rival_laws(), [&] {
            if (invocation.interrupted) throw gap::Interrupted();
        });
    } catch (const std::invalid_argument& e) {
        throw BadInput(e.what());
    } catch (const gap::Interrupted&) {
        fmt::print(stderr, "interrupted before the laws were ranked: nothing was written\n");
        return exit_interrupted;
    }
    gap::OutcomeAnswer& answer = *found;
    Diagnosis& d = answer.diagnosis;
    d.notes.insert(d.notes.begin(), warnings.begin(), warnings.end());
    d.next_experiment.description = next_outcome_text(answer);
    remove_earlier(directory);
    auto json = diagnosis_json(d, joint, answer.after);
    if (!answer.next.settings.empty()) {
        json["next_experiment"]["file"] = "next-outcome.csv";
        write_next_outcome(directory / "next-outcome.csv", answer);
    }
    write_whole(directory / "diagnosis.json", json.dump(2) + "\n");
    if (!options.no_report)
        write_report(outcome_report(answer, joint, {{"version", program_version()}, {"command", invocation.command}}),
                     directory);
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
        return exit_code_of(d, false);
    }
    fmt::print("{}\n", outcome_sentence(answer));
    for (const auto& reason : d.reasons) fmt::print("  {}\n", note_text(reason));
    for (const auto& f : answer.laws)
        fmt::print("  {:<16} {:<18} probability {:.3f}  misjudges {} of {} held-out rows\n", f.rival->law,
                   f.rival->effect, f.posterior, f.misjudged, answer.outcomes.size());
    if (!d.next_experiment.description.empty()) fmt::print("next: {}\n", d.next_experiment.description);
    fmt::print("diagnosis: {}\n", (directory / "diagnosis.json").string());
    if (!options.no_report) fmt::print("report:    {}\n", (directory / "report.html").string());
    return exit_code_of(d, false);
}

int diagnose(const Options& options, const Invocation& invocation)
{
    const Joint joint = read_joint(options.joint);
    const ThreadLimit limit(options.threads);
    for (const auto& file : options.records) {
        if (!is_outcome_file(file)) continue;
        if (options.records.size() > 1)
            throw BadInput(file + ": is a table of outcomes; it is diagnosed alone, without records or other tables");
        return diagnose_outcomes(options, joint, invocation);
    }
    refuse_twice(options.records);
    std::vector<Record> records;
    std::vector<std::string> warnings, contradictions, gaps;
    for (const auto& file : options.records) {
        auto reading = read_record(file, joint, record_layout_for(file, options.joint, joint));
        name_by_path(reading, file, options.records);
        records.push_back(std::move(reading.record));
        warnings.insert(warnings.end(), reading.warnings.begin(), reading.warnings.end());
        contradictions.insert(contradictions.end(), reading.contradictions.begin(), reading.contradictions.end());
        for (const auto& [signal, place] : reading.missing)
            if (needs_every_value(signal))
                gaps.push_back(place + "; the diagnosis needs every value, leave such rows away");
    }
    if (!gaps.empty()) throw BadInput(gaps);
    const auto directory = output_folder(options);
    gap::DiagnosisOptions settings;
    auto result = [&] {
        // a cause fitted to records in another unit would be named with confidence, and wrong
        if (!contradictions.empty()) {
            gap::DiagnosisResult refused{{}, joint};
            refused.diagnosis.motion = joint.mechanism.motion;
            for (const auto& text : contradictions)
                refused.diagnosis.reasons.push_back({text, Note::Code::contradiction});
            return refused;
        }
        StageLine line;
        settings.progress = line.listener();
        try {
            return gap::diagnose(joint, records,
                                 until_interrupted(invocation.interrupted, line.counted(parallel_for_each)), settings);
        } catch (const std::invalid_argument& e) {
            throw BadInput(e.what());
        }
    }();
    Diagnosis& d = result.diagnosis;
    d.notes.insert(d.notes.begin(), warnings.begin(), warnings.end());
    if (const auto side = side_text(joint, true); !side.empty()) d.notes.push_back(plain_text(side));

    remove_earlier(directory);
    const auto json = diagnosis_json(d, joint, result.after);
    write_whole(directory / "diagnosis.json", json.dump(2) + "\n");
    const auto corrected = corrected_joint(d, joint, result.after);
    if (!corrected.empty()) write_whole(directory / "corrected-joint.toml", corrected);
    if (!d.next_experiment.reference.empty()) write_experiment(directory / "next-experiment.csv", d.next_experiment);
    if (!options.no_report)
        write_report(
            diagnosis_report(d, joint, result.after, {{"version", program_version()}, {"command", invocation.command}},
                             corrections(corrected, joint, result.after), gap::is_rig(records.front())),
            directory);
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
        return exit_code_of(d, !contradictions.empty());
    }
    fmt::print("{}\n", diagnosis_sentence(d));
    for (const auto& reason : d.reasons) fmt::print("  {}\n", note_text(reason));
    if (contradictions.empty())
        for (const auto& warning : warnings) fmt::print("  {}\n", warning);
    for (const auto& cause : d.effects)
        fmt::print("  {:<44} probability {:.3f}  misfit {:.4g}\n", fmt::format("{}", fmt::join(cause.names, " + ")),
                   cause.probability, cause.misfit);
    if (!d.effects.empty())
        for (const auto& value : d.effects[0].values) fmt::print("  {:<44} {}\n", value.name, value_text(value));
    fmt::print("diagnosis: {}\n", (directory / "diagnosis.json").string());
    if (!options.no_report) fmt::print("report:    {}\n", (directory / "report.html").string());
    return exit_code_of(d, !contradictions.empty());
}

}  // namespace

void add_diagnose(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* verb =
        app.add_subcommand("diagnose", "Say where the gap between a joint and its records lies and what causes it");
    verb->add_option("JOINT", options->joint, "nominal joint, TOML")->required();
    verb->add_option("RECORD", options->records,
                     "records, CSV or .csv.gz, SI units unless the [record] table says otherwise; or one table of "
                     "outcomes: k_p, k_v, V0, outcome (stable | stick-slip), amplitude")
        ->required();
    verb->add_option("-o,--output", options->directory, "directory for diagnosis.json and report.html");
    verb->add_option("--threads", options->threads, "threads, 0 for all; the answer does not depend on it");
    verb->add_flag("--json", options->json, "print diagnosis.json");
    verb->add_flag("--no-report", options->no_report, "leave the page away");
    verb->footer(
        "Example: stickslip diagnose joint.toml slow.csv.gz steps.csv.gz -o diagnosis\n"
        "Example: stickslip diagnose joint.toml outcomes.csv -o which-law\n"
        "Exit codes: 0 answered (gap, no-gap, unknown), 2 bad input (suspected units included), 3 interrupted, 4 too "
        "little "
        "data.");
    verb->callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = diagnose(*options, invocation);
    });
}

}  // namespace stickslip
