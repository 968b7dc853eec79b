#include "analysis/diagnosis/verdict/settle_ladder.h"

#include "analysis/diagnosis/heldout/heldout.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/verdict/chances.h"
#include "analysis/diagnosis/verdict/quality.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Judges the ladder in place of the one before, whose causes count as what a free force is held against.
void judge_in_place(Ladder ladder, const LadderSearch& search, const Fit& fit, bool small_term, JudgedLadder& j,
                    const Effect* dropped = nullptr)
{
    JudgedLadder next;
    next.dropped = j.dropped;
    if (dropped) next.dropped.push_back(dropped);
    next.noise_below = j.noise_left || j.noise_below;
    next.with_small_terms = j.with_small_terms;
    if (small_term) next.with_small_terms = std::min(j.with_small_terms, mean_log_misfit(j.winner.evaluation));
    next.ladder = std::move(ladder);
    judge(next, search.data(), fit);
    j = std::move(next);
}

/// Whether the only cause of the last rung is one number, which may as well be as documented by its own error: what it
/// takes, others of the joint take as well.
bool is_nothing_within_error(const JudgedLadder& j, const Fit& fit)
{
    const auto& rungs = j.ladder.rungs;
    if (rungs.empty()) return false;
    const std::size_t below = rungs.size() > 1 ? rungs[rungs.size() - 2].causes.effects.size() : 0;
    const Candidate &c = j.winner.candidate, &causes = rungs.back().causes;
    if (causes.effects.size() != below + 1) return false;
    const auto is_added = [&](const Effect* e) {
        return below == 0 || std::ranges::count(rungs[rungs.size() - 2].causes.effects, e) == 0;
    };
    Eigen::Index at = 0;
    std::size_t i = 0;
    while (i < j.corrections || !is_added(c.effects[i])) at += static_cast<Eigen::Index>(c.count_of(*c.forms[i++]));
    const auto& number = c.forms[i]->parameters[0];
    const bool about_the_document = number.factor || number.low < 0;
    if (c.count_of(*c.forms[i]) > 1 || !about_the_document) return false;
    const auto covariance = quality_of(fit.cases, j.winner, fit.scales).covariance;
    return covariance.rows() > at &&
           std::abs(j.winner.x[ladder_level][at]) < policy::two_sided_95 * std::sqrt(covariance(at, at));
}

/// Whether what the last of several rungs takes of unseen rows reaches nothing within its 95 % interval over their
/// windows. Of 55 such rungs in 42 answers three did, all wrong (an inertia beside a dead zone of the drive, a memory
/// beside presliding, backlash beside a Stribeck curve of two slopes).
bool may_take_nothing(const JudgedLadder& j)
{
    const auto& rungs = j.ladder.rungs;
    if (j.noise_left || rungs.size() < 2 || frees_held_number(j.ladder)) return false;
    const auto below = rungs[rungs.size() - 2].all_left(), with = rungs.back().all_left();
    return share_between(j.ladder.documented, below, with).low <= 0;
}

/// Whether the last of several rungs takes next to nothing of the whole gap.
bool takes_next_to_nothing(const JudgedLadder& j)
{
    const auto& rungs = j.ladder.rungs;
    if (j.noise_left || rungs.size() < 2 || frees_held_number(j.ladder)) return false;
    const double taken = beyond_noise(rungs[rungs.size() - 2].all_left()) - beyond_noise(rungs.back().all_left());
    return taken < policy::least_of_further_rung * beyond_noise(j.ladder.documented);
}

/// Rungs that are small against the corrections go, those that may as well be nothing, and further ones that are less
/// likely than not, the last first. A small term of every machine goes among the corrections, or what it leaves would
/// count against the causes.
void shorten_to_likely(LadderSearch& search, const Fit& fit, const std::vector<Attribution>& pairs,
                       const OnlyNoise& only_noise, JudgedLadder& j)
{
    const auto unlikely = [&] {
        return !j.noise_left && j.ladder.rungs.size() > 1 && j.chances.back() < policy::least_chance_of_further_rung &&
               !frees_held_number(j.ladder);
    };
    // where nothing can be named beside corrections that take most of the gap, they are the answer
    const auto corrections_alone = [&] {
        return j.why_not && !j.ladder.rungs.empty() && corrections_take_most(j.shares);
    };
    while (const Effect* small = small_term_between(j))
        judge_in_place(search.without(j.ladder, *small), search, fit, true, j, small);
    while (small_against_corrections(j) || unlikely() || corrections_alone() || may_take_nothing(j) ||
           takes_next_to_nothing(j) || is_nothing_within_error(j, fit)) {
        if (auto anew =
                small_against_corrections(j) ? search.with_small_term(j.ladder, pairs, only_noise) : std::nullopt) {
            judge_in_place(std::move(*anew), search, fit, true, j);
            continue;
        }
        Ladder shorter = std::move(j.ladder);
        search.shorten(shorter);
        judge_in_place(std::move(shorter), search, fit, j.usual, j);
    }
}

/// Rungs with which the simulation of unseen records is worse than that of the document go, the last first, if that
/// helps: what predicts from row to row a little better may still push whole records away.
void shorten_to_simulated(LadderSearch& search, const Fit& fit, const std::vector<Joint>& documented, int runs,
                          JudgedLadder& j)
{
    const auto worse = [&](const JudgedLadder& ladder) {
        return hold_out(fit, documented, ladder.winner, runs).overall.worse();
    };
    if (!j.named || j.ladder.rungs.size() < 2 || !worse(j)) return;
    JudgedLadder fewer = j;
    do {
        Ladder shorter = std::move(fewer.ladder);
        search.shorten(shorter);
        judge_in_place(std::move(shorter), search, fit, false, fewer);
        if (fewer.named && !worse(fewer)) {
            j = std::move(fewer);
            return;
        }
    } while (fewer.ladder.rungs.size() > 1);
}

/// Where all numbers of a document are wrong by one factor, others that are named in the place of that predict rows to
/// within noise, and whole records not: priors hold some numbers back, and what they leave adds up.
void take_scale_if_simulated(LadderSearch& search, const Fit& fit, const std::vector<Joint>& documented, int runs,
                             JudgedLadder& j)
{
    if (!j.named || !j.noise_left) return;
    const auto gap_of = [&](const JudgedLadder& ladder) {
        const OverallGap gap = hold_out(fit, documented, ladder.winner, runs).overall;
        return std::pow(gap.after / gap.floor, 2);
    };
    double left = gap_of(j);
    if (!(left > policy::slack_of_runs)) return;
    for (auto& ladder : search.over_a_scale(j.ladder)) {
        JudgedLadder scaled = j;
        judge_in_place(std::move(ladder), search, fit, false, scaled);
        if (!scaled.named || !scaled.noise_left) continue;
        if (const double now = gap_of(scaled); policy::slack_of_runs * now < left) j = std::move(scaled), left = now;
    }
}

}  // namespace

void settle_ladder(LadderSearch& search, const Fit& fit, const Settling& with, JudgedLadder& j)
{
    shorten_to_likely(search, fit, with.pairs, with.only_noise, j);
    shorten_to_simulated(search, fit, with.documented, with.runs, j);
    take_scale_if_simulated(search, fit, with.documented, with.runs, j);
}

}  // namespace stickslip::gap
