// Which of the causes that were fitted is named, what cannot be told from it, and how likely each is.
#include "analysis/diagnosis/verdict/decide.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/moment.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/search/search.h"
#include "analysis/diagnosis/verdict/quality.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// How much of a rival's misfit may be a lost step. Where anything but noise is left, all of it counts.
double by_chance(const Attribution& winner, const Attribution& rival)
{
    return winner.accepted && rival.accepted ? hangs_on_a_moment(winner.evaluation, rival.evaluation, exact_square) : 0;
}

/// Parameters that the rival has and does not need where the winner does as well. None where the rival makes the
/// winner's very motion without them: then they tell nothing.
double needless_parameters(const Attribution& winner, const Attribution& rival)
{
    const Candidate &one = winner.candidate, &other = rival.candidate;
    return makes_the_motion_of(one, other) ? 0 : parameters_more(other, one);
}

/// Of a rival against the winner: the likelihood of their innovations over so many rows, less for needless parameters.
double odds_against(const Attribution& winner, const Attribution& rival, double rows)
{
    const double width = std::max(2 * policy::rows_per_reading / rows, policy::relative_temperature * winner.score);
    const double worse = rival.evidence - winner.evidence - by_chance(winner, rival);
    return std::exp(-std::max(0.0, worse) / width) *
           std::pow(policy::needless_parameter, -needless_parameters(winner, rival));
}

}  // namespace

Decision decide(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs, double rows)
{
    Decision d;
    const std::vector<Attribution>* from = nullptr;
    const Attribution* best_single = singles.empty() ? nullptr : &singles[0];
    const Attribution* best_pair = pairs.empty() ? nullptr : &pairs[0];
    if (best_single) d.best_explained = best_single->explained;
    // two free shapes that are not accepted come near anything: that explains nothing
    if (best_pair && (best_pair->accepted || !two_free_shapes(*best_pair)))
        d.best_explained = std::max(d.best_explained, best_pair->explained);
    if (best_single && best_single->accepted) {
        d.winner = best_single;
        from = &singles;
    } else if (best_pair && best_pair->accepted) {
        // a second effect must earn its place: else the ladder tells what the first alone leaves
        // simulated contact differs slightly from real backlash, and a partner makes up for it
        const bool doubted = best_single && two_mass_edit(best_single->candidate);
        const auto worth = doubted ? policy::worth_a_doubted_partner : policy::worth_a_partner;
        const bool alone = best_single && best_single->explained > policy::explained_single &&
                           best_single->score < best_pair->score + worth;
        if (!alone) d.winner = best_pair, from = &pairs;
    }
    d.named = d.winner != nullptr;
    if (d.named)
        for (const auto& rival : *from)
            if (&rival != d.winner && rival.refined && plausible_numbers(rival) &&
                odds_against(*d.winner, rival, rows) >= policy::odds_of_indistinguishable)
                d.ambiguous.push_back(&rival);
    return d;
}

std::vector<Ranked> rank(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs,
                         const Decision& decision, double rows)
{
    std::vector<Ranked> all;
    const bool pair_wins = decision.named && decision.winner->candidate.effects.size() > 1;
    for (const auto& s : singles) all.push_back({&s, 0});
    for (const auto& p : pairs)
        if (pair_wins || !decision.named) all.push_back({&p, 0});
    std::stable_sort(all.begin(), all.end(), [&](const Ranked& a, const Ranked& b) {
        const bool wa = a.attribution == decision.winner, wb = b.attribution == decision.winner;
        if (wa != wb) return wa;
        return a.attribution->score < b.attribution->score;
    });
    if (all.empty()) return all;
    const Attribution& first = *all.front().attribution;
    double sum = 0;
    for (auto& r : all) {
        const bool rival = r.attribution == &first || plausible_numbers(*r.attribution);
        r.probability = rival ? odds_against(first, *r.attribution, rows) : 0;
        sum += r.probability;
    }
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Ranked& a, const Ranked& b) { return a.probability > b.probability; });
    // what the best leaves unexplained is the chance that it is something else
    const double unexplained = std::clamp(1 - first.explained, 0.0, 1.0);
    const double else_ = decision.named ? policy::doubt_of_accepted + 0.5 * unexplained : 1 - policy::believed_unnamed;
    for (auto& r : all) r.probability *= (1 - else_) / sum;
    return all;
}

}  // namespace stickslip::gap
