#include "analysis/diagnosis/verdict/find_causes.h"

#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/search/search.h"

namespace stickslip::gap {
namespace {

void fit_all(Prepared& p, std::size_t pair_partners, const std::function<void(const char*, double)>& progress,
             const ParallelFor& parallel, Findings& f)
{
    progress("fitting single effects", 0.1);
    const auto fit = [&] {
        return fit_singles(p.cases, p.scales, p.nominal, single_candidates(p.cases, p.audit), parallel);
    };
    f.singles = fit();
    // a jump in the wrong place costs little beside the effect, and much once the effect is found
    if (!f.singles.empty() &&
        settle_jumps(p.cases, f.singles[0].candidate, in_si(f.singles[0].candidate, f.singles[0].x[1], p.scales))) {
        p.nominal = judge_nominal(p.cases);
        f.singles = fit();
    }
    confirm(p.cases, f.singles, p.nominal, p.scales, parallel);
    if (!f.singles.empty() && f.singles[0].accepted) return;
    progress("fitting pairs", 0.5);
    f.pairs = fit_pairs(p.cases, p.scales, p.nominal, f.singles, pair_partners, parallel);
    confirm(p.cases, f.pairs, p.nominal, p.scales, parallel);
    fit_members_alone(p.cases, p.scales, p.nominal, f.singles, f.pairs, parallel);
    confirm(p.cases, f.singles, p.nominal, p.scales, parallel);
}

/// Without a documented floor nothing can be told to be noise: what takes a good part of the misfit away is named, and
/// whatever takes half as much is said to be a rival.
void name_what_helps_most(const Nominal& nominal, const std::vector<Attribution>& singles, Decision& decision)
{
    constexpr double worth_naming = 0.2;  // of mean log misfit: a tenth of the RMS
    const auto gain = [&](const Attribution& a) { return nominal.score - a.score; };
    if (singles.empty() || !(gain(singles[0]) > worth_naming)) return;
    decision.winner = &singles[0];
    decision.named = true;
    for (const auto& rival : singles)
        if (&rival != decision.winner && gain(rival) > 0.5 * gain(singles[0])) decision.ambiguous.push_back(&rival);
}

/// A contestant, fitted at the middle level, as it stands at all of them.
Attribution at_all_levels(const Prepared& p, const Attribution& contestant)
{
    LevelFit fit;
    fit.x = contestant.x[1];
    return as_screened(p.cases, p.scales, p.nominal, contestant.candidate, fit);
}

/// The first `own_numbers` effects are refitted numbers of the joint, no causes.
std::string nearest_in_shape(const Attribution& cause, std::size_t own_numbers, const FreeFit& free)
{
    std::string names;
    for (std::size_t i = own_numbers; i < cause.candidate.effects.size(); ++i)
        names += (names.empty() ? "" : " with ") + std::string(cause.candidate.effects[i]->name);
    return names + " comes nearest, but " + in_words(free) +
           " explains the records clearly better, and has the shape of no effect of the catalogue";
}

/// The best cause against forces without a name: where one of them is clearly better, it is only the nearest in shape.
void hold_against_free_forces(const Prepared& p, const std::function<void(const char*, double)>& progress,
                              const ParallelFor& parallel, Findings& f)
{
    const Attribution nearest = f.contest.decided  ? at_all_levels(p, f.contest.ranked[0].fit)
                                : f.decision.named ? *f.decision.winner
                                                   : f.none;
    if (mean_log_misfit(nearest.evaluation) < least_of_free_force) return;
    progress("fitting forces without a name", 0.85);
    f.free = fit_free_forces(p.cases, p.scales, p.nominal, parallel);
    if (!f.named() || !clearly_better(f.free[0], nearest)) return;
    f.only_nearest = nearest_in_shape(nearest, f.contest.decided ? f.contest.own_numbers : 0, f.free[0]);
    f.decision.named = f.contest.decided = false;
    f.decision.ambiguous.clear();
}

}  // namespace

Findings find_causes(Prepared& p, std::size_t pair_partners, const std::function<void(const char*, double)>& progress,
                     const ParallelFor& parallel)
{
    Findings f;
    f.none.evaluation = p.nominal.evaluation;
    f.none.score = p.nominal.score;
    progress("measuring the floor", 0.05);
    f.quiet = f.none.accepted = at_floor(p.cases, f.none, p.nominal, p.scales, parallel);
    if (f.quiet) return f;
    fit_all(p, pair_partners, progress, parallel, f);
    f.decision = decide(f.singles, f.pairs);
    if (!f.decision.named && !p.noise_documented()) {
        progress("comparing what causes predict", 0.75);
        f.contest = hold_contest(p.cases, p.scales, f.singles, parallel);
        if (!f.contest.decided) name_what_helps_most(p.nominal, f.singles, f.decision);
    }
    hold_against_free_forces(p, progress, parallel, f);
    return f;
}

}  // namespace stickslip::gap
