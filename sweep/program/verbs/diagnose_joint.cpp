#include "sweep/program/verbs/diagnose_joint.h"

#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/plant/plant.h"
#include "analysis/diagnosis/plant/record_form.h"
#include "analysis/diagnosis/rig/rig.h"
#include "sweep/engine/build.h"
#include "sweep/files/json/diagnosis_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/changed_lines.h"
#include "sweep/files/toml/corrected_joint.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/stoppable.h"
#include "sweep/report/pages/diagnosis_report.h"
#include "sweep/report/write_linked_report.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/refusal_text.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <optional>

namespace stickslip {
namespace {

void write_experiment(const std::filesystem::path& file, const NextExperiment& experiment)
{
    std::string text = "time,reference_position\n";
    for (std::size_t k = 0; k < experiment.time.size(); ++k)
        text += fmt::format("{},{}\n", experiment.time[k], experiment.reference[k]);
    write_whole(file, text);
}

/// Signals that the simulation is driven by or compared with.
bool needs_every_value(const std::string& signal)
{
    for (const char* other : {"temperature", "torque_enable", "link_position", "normal_load"})
        if (signal == other) return false;
    return true;
}

/// What the page offers to take along.
std::vector<Snippet> corrections(const std::string& corrected, const Joint& joint, const Joint& after, bool rig)
{
    if (corrected.empty()) return {};
    return {{std::string("Changes for the joint file; documented values follow #") +
                 (rig ? "; N stands for the unit of the logged friction" : ""),
             changed_lines(joint_text(joint), joint_text(after)), ""},
            {"The whole corrected joint file", corrected, "corrected-joint.toml"}};
}

}  // namespace

void GatheredRecords::add(RecordReading reading)
{
    const std::string& name = reading.record.name;
    for (auto& text : reading.warnings) warnings.push_back({.text = std::move(text)});
    for (auto& text : reading.guesses) warnings.push_back({.record = name, .text = std::move(text)});
    for (auto& suspicion : reading.suspicions) {
        suspicion.record = name;
        if (contradicts(suspicion)) contradictions.push_back(suspicion);
        warnings.push_back(std::move(suspicion));
    }
    if (!reading.no_position.empty() && !gap::is_rig(reading.record)) gaps.push_back(std::move(reading.no_position));
    records.push_back(std::move(reading.record));
    for (const auto& [signal, place] : reading.missing)
        if (needs_every_value(signal)) gaps.push_back(place + "; the diagnosis needs every value; remove these rows");
}

/// The exit code of `diagnose`.
int exit_code_of(const Diagnosis& d, bool contradicted)
{
    if (contradicted) return exit_bad_input;
    if (d.interrupted) return exit_interrupted;
    return d.verdict == Verdict::insufficient_data ? exit_insufficient : exit_done;
}

/// The folder of the answer, tried before the work and not after it.
std::filesystem::path answer_folder(const std::string& directory)
{
    if (directory.empty()) throw BadInput("--output: is empty, expected a folder");
    const std::filesystem::path probe = std::filesystem::path(directory) / "diagnosis.json.probe";
    write_whole(probe, "");
    std::filesystem::remove(probe);
    return directory;
}

/// What an earlier answer left there would contradict this one.
void remove_earlier(const std::filesystem::path& directory)
{
    for (const char* name : {"report.html", "next-experiment.csv", "next-outcome.csv", "corrected-joint.toml"})
        std::filesystem::remove(directory / name);
}

void require_fitted(const Joint& joint, const GatheredRecords& records, const std::string& file)
{
    if (records.records.empty() || gap::is_rig(records.records.front())) return;
    try {
        gap::flatten(gap::record_form(joint));
    } catch (const std::invalid_argument& e) {
        throw BadInput(file + ": " + refusal_text(e));
    }
}

JointDiagnosis diagnose_joint(const Joint& documented, const GatheredRecords& given, const Invocation& invocation,
                              StageLine& line, const std::string& about)
{
    if (!given.gaps.empty()) throw BadInput(given.gaps);
    JointDiagnosis found;
    try {
        found = diagnose_records(
            documented, given.records, given.contradictions,
            until_interrupted<gap::Interrupted>(invocation.interrupted, line.counted(parallel_for_each)),
            line.listener(about));
    } catch (const std::invalid_argument& e) {
        throw BadInput(refusal_text(e));
    }
    Diagnosis& d = found.diagnosis;
    d.notes.insert(d.notes.begin(), given.warnings.begin(), given.warnings.end());
    if (const auto side = gear_side(found.before); side.between())
        d.notes.push_back({.text = plain_text(side_text(side, true))});
    if (const auto law = found.rig ? "" : gap::rewritten_law(documented); !law.empty())
        d.notes.push_back({.text = rewritten_law_text(law)});
    if (const auto keys = found.rig ? std::vector<std::string>{} : gap::left_out_of_records(documented); !keys.empty())
        d.notes.push_back({.text = left_out_text(keys)});
    return found;
}

std::string joint_diagnosis_json(const JointDiagnosis& found)
{
    return diagnosis_json(found.diagnosis, found.windows).dump(2) + "\n";
}

bool write_joint_diagnosis(const JointDiagnosis& found, const std::filesystem::path& directory,
                           const Invocation& invocation, bool page, const JointOfRobot& of)
{
    const auto& [d, before, after, windows, contradicted, rig] = found;
    remove_earlier(directory);
    write_whole(directory / "diagnosis.json", joint_diagnosis_json(found));
    const auto corrected = corrected_joint_text(d, before, after);
    if (!corrected.empty()) write_whole(directory / "corrected-joint.toml", corrected);
    if (!d.next_experiment.reference.empty()) write_experiment(directory / "next-experiment.csv", d.next_experiment);
    if (!page) return true;
    const bool named = d.verdict == Verdict::gap && !rig;
    const double velocity = named ? reported_velocity(before, d.usual_speed) : missing;
    const auto moved = moved_boundary(before, after, velocity);
    std::optional<StageLine> line(std::in_place);
    line->stage("gains that would be right");
    const auto gains =
        corrected_gains(before, after, velocity,
                        until_interrupted<gap::Interrupted>(invocation.interrupted, line->counted(parallel_for_each)));
    line.reset();
    auto report = diagnosis_report(d, before, after, moved, gains,
                                   {{"version", program_version()}, {"command", invocation.command}},
                                   corrections(corrected, before, after, rig), rig);
    if (!of.name.empty()) report.title = "Sim-to-real gap of " + of.name;
    write_linked_report(report, directory, {}, {of.robot, of.page});
    return gains.none != NoGains::interrupted;
}

}  // namespace stickslip
