#include "analysis/diagnosis/diagnose.h"

#include "analysis/base/require_valid.h"
#include "analysis/diagnosis/audit/continuous_loop.h"
#include "analysis/diagnosis/audit/effort_drive.h"
#include "analysis/diagnosis/audit/inspect.h"
#include "analysis/diagnosis/audit/noisy_rows.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/heldout/drive_force.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/records/near_clock.h"
#include "analysis/diagnosis/records/pieces.h"
#include "analysis/diagnosis/report_findings.h"
#include "analysis/diagnosis/rig/rig.h"
#include "analysis/diagnosis/verdict/causes.h"
#include "analysis/diagnosis/verdict/controller_cause.h"
#include "analysis/diagnosis/verdict/find_causes.h"
#include "analysis/diagnosis/verdict/locate_stages.h"
#include "analysis/diagnosis/verdict/long_records.h"
#include "analysis/diagnosis/verdict/reject.h"
#include "analysis/diagnosis/verdict/report_ladder.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

/// Where so much of controller and encoder differs from the document that it is hardly the same joint.
std::optional<Note> another_joint(const Audit& audit)
{
    if (static_cast<double>(audit.findings.size()) < policy::findings_of_another_joint) return std::nullopt;
    Note note{Note::Code::another_joint};
    for (const auto& f : audit.findings) note.names.push_back(f.parameter), note.values.push_back(f.value);
    return note;
}

void describe_data(const std::vector<Case>& cases, Diagnosis& d)
{
    for (const auto& c : cases) {
        d.records.push_back({c.ticks.name, "held-out"});
        if (c.ticks.lost)
            d.notes.push_back({Note::Code::rows_missing, c.ticks.name});
        else if (!c.ticks.regular)
            d.notes.push_back({Note::Code::irregular_rows, c.ticks.name});
        if (c.ticks.rebuilt)
            d.notes.push_back({Note::Code::rebuilt_ticks, c.ticks.name});
        else if (c.ticks.ticks_per_row > 1)
            d.notes.push_back({Note::Code::slow_log, c.ticks.name});
    }
    d.notes.push_back({cases.size() > 1 ? Note::Code::held_out_in_turn : Note::Code::thirds_in_turn});
}

/// The pieces of records that are long enough; why others are not stands in the reasons.
std::vector<Record> usable_pieces(const Joint& joint, const std::vector<Record>& records, Diagnosis& d)
{
    std::vector<Record> usable;
    for (const auto& whole : records) {
        const auto found = inspect(whole, joint);
        if (!found.errors.empty()) throw found.errors.front();
        d.notes.insert(d.notes.end(), found.notes.begin(), found.notes.end());
        if (!found.shortages.empty()) {
            d.reasons.insert(d.reasons.end(), found.shortages.begin(), found.shortages.end());
            continue;
        }
        auto uninterrupted = pieces(whole, d.notes);
        for (auto& piece : uninterrupted) {
            const auto left = uninterrupted.size() > 1 ? inspect(piece, joint).shortages : std::vector<Note>();
            d.reasons.insert(d.reasons.end(), left.begin(), left.end());
            if (left.empty()) usable.push_back(std::move(piece));
        }
    }
    return usable;
}

/// Records as cases, with the joint that the audit leaves; scales and the nominal joint's misfit are not yet known.
Prepared audited(const Joint& joint, std::vector<Record> records, Diagnosis& d)
{
    Prepared p;
    const EffortDrive drive = drive_by_effort(records, joint, d.notes);
    for (std::size_t i = 0; i < records.size(); ++i)
        p.cases.push_back(prepare(records[i], joint, d.notes)), p.cases.back().number = i;
    find_continuous_loop(p.cases, d.notes);
    share_noise(p.cases, joint.sensor, d.notes);
    for (const auto& c : p.cases) p.documented.push_back(c.joint);
    p.audit = audit(p.cases);
    if (!p.audit.findings.empty()) find_integrals(p.cases);  // as the controller that it found held them
    audit_effort(drive, p.cases, p.audit, d.reasons);
    mark_noisy_rows(p.cases);
    describe_data(p.cases, d);  // the audit may take back what was rebuilt between rows
    d.notes.insert(d.notes.end(), p.audit.notes.begin(), p.audit.notes.end());
    return p;
}

/// Where no effect is needed.
void judge_quiet(const Prepared& p, const ParallelFor& parallel, Diagnosis& d)
{
    d.verdict = could_have_shown(p.fit(parallel)) ? Verdict::no_gap : Verdict::insufficient_data;
    d.reasons.push_back({d.verdict == Verdict::no_gap ? Note::Code::within_noise : Note::Code::nothing_would_show});
}

/// Writes down what was found, held against data that no fit has seen.
void conclude(const Prepared& p, Findings& f, int runs, const ParallelFor& parallel, DiagnosisResult& result)
{
    Diagnosis& d = result.diagnosis;
    const bool wrong_controller = !p.audit.findings.empty();
    if (f.within_noise && !wrong_controller)
        judge_quiet(p, parallel, d);
    else
        d.verdict = f.named() || wrong_controller ? Verdict::gap : Verdict::unknown;
    const bool shown = d.verdict == Verdict::gap;

    // the named set first, then everything that was fitted, by probability
    const auto ranked =
        f.within_noise || f.by_ladder ? std::vector<Ranked>{} : rank(f.singles, f.pairs, f.decision, rows_of(p.cases));
    const Attribution& winner = !f.named() ? f.none : in_the_ladder(f) ? f.judged.winner : *f.decision.winner;
    const bool audit_alone = winner.candidate.effects.empty();
    const auto held = held_out(p, parallel, shown ? winner : f.none, runs);
    d.gap = held.signals;
    d.overall = held.overall;
    d.traces = held.traces;
    reject_no_gap(d);
    d.notes.insert(d.notes.end(), held.notes.begin(), held.notes.end());
    if (shown && audit_alone) {
        d.effects.push_back(
            cause_of(p, f.none, f.within_noise ? 1 - policy::doubt_of_finding : policy::finding_and_more));
        if (!f.within_noise) d.reasons.push_back({Note::Code::controller_and_rest});
    } else if (f.by_ladder) {
        report_named(p, parallel, f, d);
    } else {
        list_effects(p, ranked, d);
        if (!d.effects.empty() && shown) report_first(p, f, held, d.effects[0]);
    }
    if (d.verdict == Verdict::unknown && !f.within_noise && !f.why_not) report_unexplained(f, d);
    double audited = 0;
    if (wrong_controller && !p.cases[0].controller_error.empty()) {
        audited = share_of_controller(d.signals) * p.audit.findings[0].gain;
    } else if (wrong_controller) {
        const auto alone = audit_alone ? held : held_out(p, parallel, f.none, runs);
        audited = std::clamp(alone.overall.explained, 0.0, 1.0);
    }
    report_ladder(p, f, audited, d);
    const bool only_numbers = f.judged.only_corrections && f.judged.noise_left;
    const bool closed_loop = p.cases[0].controller_error.empty();  // else both were found independently
    if (f.by_ladder && !audit_alone && wrong_controller && shown && !only_numbers && closed_loop)
        put_controller_in_order(cause_of(p, f.none, 0), f.judged, d);
    if (!f.climbed && shown) d.remainder.share = f.within_noise ? 0 : std::clamp(1 - held.overall.explained, 0.0, 1.0);
    if (shown) report_rivals(p, parallel, f, ranked, winner, d);
    if (shown) report_filter(p, d);
    const bool settled =
        f.within_noise || f.by_ladder || (f.named() && f.decision.winner->accepted) || wrong_controller;
    if (!shown || reject_if_not_validated(d, {settled, p.noise_documented(), f.by_ladder, wrong_controller ? 1u : 0u}))
        return;
    const Joint documented = result.after;
    result.after = p.cases[0].joint;
    if (p.cases[0].ticks.source == CommandSource::measured)
        result.after.actuator = documented.actuator, result.after.control.delay = documented.control.delay;
    if (!audit_alone)
        result.after = edited(result.after, winner.candidate, in_si(winner.candidate, winner.x[1], p.scales), 0);
}

/// All that is done with records of a joint, stage by stage; what each found stands in the result when the next begins.
void find(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel_tasks,
          const DiagnosisOptions& options, const StageProgress& tell, DiagnosisResult& result)
{
    Diagnosis& d = result.diagnosis;
    StageMeter meter(parallel_tasks, tell);
    const ParallelFor parallel = [&](std::size_t n, const std::function<void(std::size_t)>& task) {
        meter.run(n, task);
    };
    meter.begin(DiagnosisStage::reading);
    auto usable = usable_pieces(joint, any_far_clock(records) ? on_near_clocks(records) : records, d);
    if (usable.empty()) return;
    meter.begin(DiagnosisStage::auditing_controller);
    Prepared prepared = audited(joint, std::move(usable), d);
    if (auto suspicion = another_joint(prepared.audit)) {
        d.reasons.push_back(*suspicion);
        return;
    }
    settle_jumps(prepared.cases, {}, {});
    prepared.scales = scales_of(prepared.cases);
    d.usual_speed = prepared.scales.velocity;
    d.signals = locate_signals(prepared.cases, prepared.documented);
    d.regimes = locate_regimes(prepared.cases);
    take_stretches(prepared, d);
    prepared.nominal = judge_nominal(prepared.cases);
    Findings findings;
    try {
        find_causes(prepared, options.pair_partners, options.ensemble, meter, parallel, findings);
        if (findings.why_not) d.reasons.push_back(*findings.why_not);
        meter.begin(DiagnosisStage::predicting_unseen);
        conclude(prepared, findings, options.ensemble, parallel, result);
    } catch (const Interrupted&) {
        d.effects.clear();
        // none is named: what a probability would be of is not known before all were looked at
        findings.decision = decide(findings.singles, findings.pairs, rows_of(prepared.cases));
        findings.decision.named = false;
        list_effects(prepared, rank(findings.singles, findings.pairs, findings.decision, rows_of(prepared.cases)), d);
        throw;
    }
    meter.begin(DiagnosisStage::done);
}

/// What was found before the interruption stays; a cause that was not held against other data is none.
void report_interrupted(DiagnosisStage stage, const Joint& joint, DiagnosisResult& result)
{
    Diagnosis& d = result.diagnosis;
    d.interrupted = true;
    d.verdict = Verdict::unknown;
    d.ladder.clear();
    d.ambiguous_with.clear();
    d.next_experiment = {};
    if (d.overall.floor == 0) d.overall = {missing, missing, missing, missing};  // nothing was predicted yet
    result.after = joint;
    d.reasons = {{.code = d.signals.empty() ? Note::Code::interrupted_early : Note::Code::interrupted_located,
                  .names = stages_from(stage)}};
}

}  // namespace

std::string DiagnosisOptions::problem() const
{
    return problem_unless(ensemble >= 2, "ensemble", ensemble, "at least 2: a spread needs two runs");
}

DiagnosisResult diagnose(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel,
                         const DiagnosisOptions& options)
{
    require_valid(options);
    DiagnosisResult result{{}, joint};
    result.diagnosis.motion = joint.mechanism.motion;
    if (records.empty()) throw CannotAnswer(CannotAnswer::Why::no_record, "");
    DiagnosisStage stage = DiagnosisStage::reading;
    const auto progress = [&](DiagnosisStage begins, double done) {
        stage = begins;
        if (options.progress) options.progress(stage, done);
    };
    try {
        if (std::ranges::all_of(records, is_rig)) return diagnose_rig(joint, records, parallel);
        find(joint, records, parallel, options, progress, result);
    } catch (const Interrupted&) {
        report_interrupted(stage, joint, result);
    }
    return result;
}

}  // namespace stickslip::gap
