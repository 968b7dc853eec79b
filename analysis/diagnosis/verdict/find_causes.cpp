#include "analysis/diagnosis/verdict/find_causes.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/heldout/heldout.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/search/search.h"
#include "analysis/diagnosis/verdict/chances.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "analysis/diagnosis/verdict/settle_ladder.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

void fit_single(Prepared& p, const Fit& fit, StageMeter& meter, Findings& f)
{
    meter.begin(DiagnosisStage::fitting_singles);
    f.singles = fit_singles(fit, single_candidates(p.cases, p.audit));
    // a jump in the wrong place costs little beside the effect, and much once the effect is found
    if (!f.singles.empty() &&
        settle_jumps(p.cases, f.singles[0].candidate, in_si(f.singles[0].candidate, f.singles[0].x[1], p.scales))) {
        p.nominal = judge_nominal(p.cases);
        f.singles = fit_singles(fit, single_candidates(p.cases, p.audit));
    }
    confirm(fit, f.singles);
}

void fit_pair(const Fit& fit, std::size_t pair_partners, Findings& f)
{
    for (auto& pair : fit_pairs(fit, f.singles, pair_partners))
        if (std::ranges::none_of(f.pairs, [&](const auto& has) { return has.candidate.forms == pair.candidate.forms; }))
            f.pairs.push_back(std::move(pair));
    confirm(fit, f.pairs);
    fit_members_alone(fit, f.singles, f.pairs);
    confirm(fit, f.singles);
}

/// What is accepted as it is. A cause that needs a number that no joint has, such as a wave longer than its record, is
/// not: beside corrections another one may do without.
Decision decided(const Prepared& p, const Findings& f)
{
    Decision d = decide(f.singles, f.pairs, rows_of(p.cases));
    if (d.named &&
        !plausible(d.winner->candidate, d.winner->x[ladder_level], p.scales, p.cases[0].joint, policy::ladder.ranges)) {
        d.named = false;
        d.ambiguous.clear();
    }
    return d;
}

/// The best cause against unmodelled forces: where one of them is clearly better, it is only the nearest in shape.
void hold_against_free_forces(const Fit& fit, StageMeter& meter, Findings& f)
{
    const Attribution& nearest = *f.decision.winner;
    if (mean_log_misfit(nearest.evaluation) < policy::least_of_free_force) return;
    meter.begin(DiagnosisStage::fitting_free_forces);
    f.free = fit_free_forces(fit);
    if (!clearly_better(f.free[0], nearest)) return;
    f.why_not = Note{
        .code = Note::Code::nearer_force, .names = names_of(nearest.candidate), .signal = std::string(f.free[0].of)};
    f.decision.named = false;
    f.decision.ambiguous.clear();
}

/// The same for a ladder that leaves more than noise, with the corrections refitted beside those forces, too.
void hold_ladder_against_free_forces(const Fit& fit, StageMeter& meter, Findings& f)
{
    JudgedLadder& j = f.judged;
    const bool only_noise = j.noise_left || j.noise_below;
    if (!j.answers() || only_noise || mean_log_misfit(j.winner.evaluation) < policy::least_of_free_force) return;
    meter.begin(DiagnosisStage::fitting_free_forces);
    f.free = fit_free_forces(fit, j.ladder.corrections.get());
    hold_against(j, f.free[0]);
}

/// What explains to within noise with the document's numbers as they are is the answer, with a ladder of its own
/// causes; unless beside corrections a part of it does as well, which then is.
void note_accepted(LadderSearch& search, const Fit& fit, Findings& f)
{
    f.judged.ladder = search.of(*f.decision.winner);
    judge(f.judged, search.data(), fit);
    f.climbed = true;
    f.by_ladder = f.judged.ladder.last().causes.effects != f.decision.winner->candidate.effects;
}

/// Whether corrections leave no more than the joint's own noise makes, or than the cause does, which simulates unseen
/// records no better than they do: predictions from row to row can hide in an encoder's steps what adds up over a
/// record.
bool do_as_well(const Attribution& corrected, const Fit& fit, const std::vector<Joint>& documented, int runs,
                const Attribution& cause)
{
    const double left = mean_log_misfit(corrected.evaluation), by_cause = mean_log_misfit(cause.evaluation);
    if (left > by_cause + policy::margin_of_score && !at_floor(fit, corrected)) return false;
    const auto square_after = [&](const Attribution& a) {
        return std::pow(hold_out(fit, documented, a, runs).overall.after, 2);
    };
    return square_after(corrected) <= policy::slack_of_runs * square_after(cause);
}

/// Whether the document, off by no more than documents usually are, is accepted as the cause is: then it needs none.
/// Every document is a little off; few joints have that cause.
bool document_suffices(LadderSearch& search, const Fit& fit, const std::vector<Joint>& documented, int runs,
                       Findings& f)
{
    if (!search.usually_off()) return false;
    const Attribution corrected = at_all_levels(fit, search.corrected());
    if (!corrected.accepted && !do_as_well(corrected, fit, documented, runs, *f.decision.winner)) return false;
    f.judged = {};
    f.judged.ladder = search.climb({}, 0);
    judge(f.judged, search.data(), fit);
    f.climbed = f.by_ladder = true;
    f.why_not = f.judged.why_not;
    return true;
}

/// Whether corrections are the answer and most of that is a load that no document states.
bool most_is_a_load(const JudgedLadder& j, const std::vector<FarNumber>& far)
{
    return j.only_corrections && std::ranges::any_of(j.numbers, [&](const auto& number) {
               const auto load = std::ranges::find(far, number.first, &FarNumber::effect);
               return load != far.end() && load->unstated_load && number.second.share > policy::least_of_gap;
           });
}

/// The rungs that a climb has come to, and the far numbers beside them. A load that is most of the answer is climbed to
/// as a cause, because another may make nearly the same motion: gravity at another angle, an encoder that is off.
void settle(LadderSearch& search, const Fit& fit, const Settling& with, JudgedLadder& j)
{
    settle_ladder(search, fit, with, j);
    if (!j.answers()) return;
    const auto far = search.far_off(j.ladder);
    count_far_numbers(j, far);
    if (!most_is_a_load(j, far)) return;
    JudgedLadder released;
    released.ladder = search.with_load_released(with.pairs, with.only_noise);
    judge(released, search.data(), fit);
    settle_ladder(search, fit, with, released);
    if (!released.named) return search.hold_load();
    count_far_numbers(released, search.far_off(released.ladder));
    j = std::move(released);
}

bool accepted(const Decision& d)
{
    return d.named && d.winner->accepted;
}

/// Whether another cause makes the very motion of the winner but for a number that documents have a little wrong, and
/// so is no rival of it as long as nothing is corrected: gravity has its amplitude beside an angle that an encoder's
/// zero may make as well.
bool has_a_double(const Findings& f)
{
    const Decision& d = f.decision;
    return std::ranges::any_of(f.singles, [&](const Attribution& s) {
        return &s != d.winner && std::ranges::count(d.ambiguous, &s) == 0 &&
               makes_the_motion_of(s.candidate, d.winner->candidate);
    });
}

/// Climbs beside corrections, with pairs where one cause leaves what is worth their search. A pair may be accepted as
/// it is, unless what was accepted has been refused.
void climb_ladder(const Prepared& p, const Fit& fit, const LadderRules& rules, std::size_t pair_partners, int runs,
                  StageMeter& meter, Findings& f)
{
    meter.begin(DiagnosisStage::correcting_numbers);
    LadderSearch search(fit, f.singles, rules);
    const auto only_noise = [&](const FittedSet& set) { return leaves_noise(fit, set); };
    f.judged = {};
    f.judged.ladder = search.climb({}, 1);
    judge(f.judged, search.data(), fit);
    f.climbed = f.by_ladder = true;
    if (!f.judged.noise_left) {
        const Shares& s = f.judged.shares;
        const double left = s.rungs.empty() ? s.base : s.rungs[0];
        const bool nothing_alone = s.rungs.empty() && !f.judged.only_corrections;
        if (nothing_alone || left - s.explainable_to > policy::worth_a_search_of_pairs * s.base) {
            meter.begin(DiagnosisStage::fitting_pairs);
            fit_pair(fit, pair_partners, f);
            f.decision = decided(p, f);
            if (f.why_not) f.decision.named = false;
        }
        if (!accepted(f.decision)) {
            meter.begin(DiagnosisStage::climbing_ladder);
            f.judged = {};
            f.judged.ladder = search.climb(f.pairs, rules.most_rungs, only_noise);
            judge(f.judged, search.data(), fit);
        }
    }
    if (!accepted(f.decision)) settle(search, fit, {f.pairs, only_noise, p.documented, runs}, f.judged);
}

}  // namespace

void find_causes(Prepared& p, std::size_t pair_partners, int runs, StageMeter& meter, const ParallelFor& parallel,
                 Findings& f)
{
    const Fit fit = p.fit(parallel);
    LadderRules rules = policy::ladder;
    // stretches of one record have one Coulomb level
    if (p.whole.size() == 1) rules.prior.coulomb_of_record = 0;
    f.none.evaluation = p.nominal.evaluation;
    f.none.score = p.nominal.score;
    meter.begin(DiagnosisStage::measuring_floor);
    f.within_noise = f.none.accepted = at_floor(fit, f.none);
    if (f.within_noise) return;
    fit_single(p, fit, meter, f);
    if (!f.singles.empty() && !f.singles[0].accepted) {
        f.pairs = fit_parts(fit, f.singles);
        confirm(fit, f.pairs);
    }
    f.decision = decided(p, f);
    if (!accepted(f.decision) || has_a_double(f)) climb_ladder(p, fit, rules, pair_partners, runs, meter, f);
    if (accepted(f.decision) && !(f.by_ladder && f.judged.noise_left)) {
        const std::vector<Attribution> none;
        LadderSearch search(fit, none, rules);
        if (document_suffices(search, fit, p.documented, runs, f)) return;
        f.by_ladder = false;
        hold_against_free_forces(fit, meter, f);
        // a free force takes the small errors of every document along: beside their corrections it may be no better
        if (f.decision.named) {
            f.judged = {};
            note_accepted(search, fit, f);
        } else {
            climb_ladder(p, fit, rules, pair_partners, runs, meter, f);
        }
    }
    if (f.by_ladder) hold_ladder_against_free_forces(fit, meter, f);
    if (f.by_ladder) f.why_not = f.judged.why_not;
}

}  // namespace stickslip::gap
