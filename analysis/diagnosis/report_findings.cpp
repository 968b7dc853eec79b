#include "analysis/diagnosis/report_findings.h"

#include "analysis/diagnosis/heldout/drive_force.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/verdict/causes.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "analysis/diagnosis/verdict/report_ladder.h"
#include "analysis/diagnosis/verdict/unresolved_memory.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stickslip::gap {
void report_named(const Prepared& p, const ParallelFor& parallel, const Findings& f, Diagnosis& d)
{
    const JudgedLadder& j = f.judged;
    if (j.only_corrections && j.noise_left && !p.audit.findings.empty()) {
        // what the controller's regression found is the cause, and what is left beside it are a document's few per cent
        d.effects = {cause_of(p, f.none, 1 - policy::doubt_of_noise)};
        d.reasons.push_back({Note::Code::controller_and_numbers});
        return;
    }
    d.effects = causes_of(p, j);
    if (!j.answers()) return;
    Note note{.code = Note::Code::cause_predicts_best, .names = d.effects[0].names};
    if (j.only_corrections)
        note.code = j.noise_left ? Note::Code::numbers_to_noise : Note::Code::numbers_and_rest;
    else if (j.noise_left)
        note.code = Note::Code::cause_to_noise;
    d.reasons.push_back(note);
    if (j.only_corrections) return;
    if (const double corner = drive_force_corner(p.cases); corner > 0) {
        const Fit fit = p.fit(parallel);
        const auto base = at_all_levels(fit, j.ladder.corrected);
        std::vector<Attribution> rivals;
        for (const auto& rival : j.ladder.rivals[0]) rivals.push_back(at_all_levels(fit, rival.named()));
        std::vector<const Attribution*> models{&base, &j.winner};
        for (const auto& rival : rivals) models.push_back(&rival);
        const auto forces = hold_out_drive_force(fit, models);
        d.drive_force = {std::string(unit_of(Quantity::effort, Units(d.motion))), corner, forces[0].rms, forces[1].rms};
        for (std::size_t i = 1; i < forces.size() && i <= d.effects.size(); ++i) {
            d.effects[i - 1].force_gain = forces[i].gain;
            d.effects[i - 1].force_gain_interval = forces[i].spread;
        }
    }
    std::ranges::stable_sort(d.effects, std::greater{}, &Cause::probability);
}

void report_unexplained(const Findings& f, Diagnosis& d)
{
    d.reasons.push_back({.code = Note::Code::unexplained, .values = {1 - f.decision.best_explained}});
    if (f.free.empty() || !(f.free[0].fit.explained > policy::worth_a_hint)) return;
    d.reasons.push_back(
        {.code = Note::Code::free_force, .signal = std::string(f.free[0].of), .values = {f.free[0].fit.explained}});
}

void report_filter(const Prepared& p, Diagnosis& d)
{
    if (d.effects.empty()) return;
    const Control& control = p.documented[0].control;
    const double documented = control.velocity_estimate.tau,
                 tick = is_set(control.period) ? control.period : p.cases[0].row_step;
    if (!(documented > 0)) return;
    for (const auto& number : d.effects[0].parameters) {
        if (number.name != "velocity-filter.tau") continue;
        // v += g (difference - v): the file means g = T/(tau + T); the exact response to a held input
        // has this one (Franklin, Powell and Workman 1998)
        const double exact = -std::expm1(-tick / documented), found = tick / (number.value + tick);
        const double error = is_set(number.standard_error) ? policy::two_sided_95 * number.standard_error * tick /
                                                                 std::pow(number.value + tick, 2)
                                                           : 0.0;
        if (std::abs(found - exact) > std::max(policy::flagged_gain * exact, error)) continue;
        d.notes.push_back({.code = Note::Code::filter_as_exponential, .values = {number.value, documented}});
        return;
    }
}

namespace {

void report_indistinguishable(const Prepared& p, const ParallelFor& parallel, const Findings& f,
                              const std::vector<Ranked>& ranked, const Attribution& winner, Diagnosis& d)
{
    if (f.by_ladder) {
        if (f.judged.only_corrections)
            for (std::size_t i = 1; i < d.effects.size(); ++i)
                if (d.effects[i].probability >= policy::odds_of_indistinguishable * d.effects[0].probability)
                    d.ambiguous_with.push_back(d.effects[i].names);
        if (!f.judged.named) return;
        const auto near = indistinguishable(f.judged);
        for (const auto& rival : near)
            if (const auto names = with_findings(p, rival.names); std::ranges::count(d.ambiguous_with, names) == 0)
                d.ambiguous_with.push_back(names);
        // the refitted numbers are no part of what is distinguished
        const auto& others = f.judged.ladder.rivals[0];
        if (near.empty() && others.empty()) return;
        const auto rival = at_all_levels(p.fit(parallel), near.empty() ? others[0] : *near.front().set);
        d.next_experiment = design_experiment(p.cases[0], p.scales, winner, rival);
        if (!d.next_experiment.separates.empty())
            d.next_experiment.separates = {
                near.empty() ? std::pair{names_of(f.judged.ladder.rungs[0].causes)[0], names_of(others[0].causes)[0]}
                             : near.front().separates};
        return;
    }
    for (const auto* rival : f.decision.ambiguous)
        d.ambiguous_with.push_back(with_findings(p, names_of(rival->candidate)));
    const Attribution* rival = !f.decision.ambiguous.empty() ? f.decision.ambiguous.front()
                               : ranked.size() > 1           ? ranked[1].attribution
                                                             : nullptr;
    if (!rival || winner.candidate.effects.empty()) return;
    d.next_experiment = design_experiment(p.cases[0], p.scales, winner, *rival);
    auto named = names_of(winner.candidate);
    const std::size_t refitted = in_the_ladder(f) ? std::min(f.judged.corrections, named.size()) : 0;
    named.erase(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(refitted));
    if (!named.empty()) d.next_experiment.separates = {{joined(named), joined(names_of(rival->candidate))}};
}

}  // namespace

void report_rivals(const Prepared& p, const ParallelFor& parallel, const Findings& f, const std::vector<Ranked>& ranked,
                   const Attribution& winner, Diagnosis& d)
{
    report_indistinguishable(p, parallel, f, ranked, winner, d);
    doubt_unresolved_memory(p.cases, p.scales, d);
}

void list_effects(const Prepared& p, const std::vector<Ranked>& ranked, Diagnosis& d)
{
    constexpr std::size_t most_listed = 8;  // numerical: length of a list
    for (const auto& r : ranked)
        if (d.effects.size() < most_listed) d.effects.push_back(cause_of(p, *r.attribution, r.probability));
}

bool in_the_ladder(const Findings& f)
{
    if (f.by_ladder || !f.climbed || !f.named()) return f.by_ladder;
    const Candidate &of_ladder = f.judged.ladder.last().causes, &named = f.decision.winner->candidate;
    return of_ladder.effects == named.effects && of_ladder.forms == named.forms;
}

void report_first(const Prepared& p, const Findings& f, const HeldOut& held, Cause& cause)
{
    cause.heldout_gain = held.gain, cause.heldout_gain_interval = held.gain_interval;
    if (!in_the_ladder(f)) return;
    Cause corrected = cause_of(p, f.judged.winner, 1, f.judged.corrections);
    cause.parameters = std::move(corrected.parameters), cause.values = std::move(corrected.values);
}

}  // namespace stickslip::gap
