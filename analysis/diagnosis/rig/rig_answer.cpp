#include "analysis/diagnosis/rig/rig_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

void describe(const Rig& rig, const std::vector<Record>& records, Diagnosis& d)
{
    for (const auto& r : records) d.records.push_back({r.name, "held-out"});
    d.notes.push_back({Note::Code::rig});
    for (const auto& run : rig.runs)
        if (run.to - run.from < records[run.record].rows())
            d.notes.push_back({.code = Note::Code::rig_turns_round,
                               .record = records[run.record].name,
                               .values = {static_cast<double>(run.from + 1), static_cast<double>(run.to)}});
    d.notes.push_back({Note::Code::rig_blocks_in_turn});
}

void add_gap(const Rig& rig, double before, double after, double noise, Diagnosis& d)
{
    const std::string unit(unit_of(Quantity::effort, Units(d.motion)));
    const double whole = before * before - noise * noise;
    d.gap.push_back(
        {"friction", unit, before, after, noise, whole > 0 ? (before * before - after * after) / whole : 0});
    d.overall = {before / noise, after / noise, 1, d.gap[0].explained};
    d.usual_speed = rig.speed;
    Share share{"motion", 1};
    share.rms = before, share.floor = noise, share.unit = unit;
    d.signals.push_back(share);
    if (d.verdict == Verdict::gap) d.remainder.share = std::clamp(1 - d.gap[0].explained, 0.0, 1.0);
}

std::vector<DiagnosedTrace> traces_of(const Rig& rig, const std::vector<Record>& records, RigLaw law,
                                      const RigNumbers& p)
{
    std::vector<double> levels, means;
    const auto force = rig_force(rig, law, p);
    rig_square(rig, force, -1, false, &levels);
    rig_square(rig, rig_force(rig, RigLaw::level, p), -1, false, &means);
    std::vector<DiagnosedTrace> traces;
    for (std::size_t r = 0; r < rig.runs.size(); ++r) {
        const RigRun& run = rig.runs[r];
        DiagnosedTrace trace;
        trace.file = records[run.record].name;
        trace.effort = DiagnosedTrace::Effort::friction_of_rig;
        trace.effort_unit = "as logged";
        for (std::size_t k = 0; k < run.time.size(); k += 2) {
            trace.time.push_back(run.time[k]);
            for (auto* t : {&trace.measured, &trace.before, &trace.after}) t->push_back(run.displacement[k]);
            trace.effort_measured.push_back(run.friction[k]);
            trace.effort_before.push_back(means[run.level]);
            trace.effort_after.push_back(levels[run.level] + force[r][k]);
        }
        traces.push_back(std::move(trace));
    }
    return traces;
}

}  // namespace stickslip::gap
