#include "analysis/gap/excerpt.h"
#include "analysis/gap/search.h"
#include "analysis/gap/seeds.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t refined_pairs = 6;
constexpr int first_look = 3, first_effort = 8;                      // iterations; evaluations a parameter
constexpr std::size_t simple_finalists = 16, divided_finalists = 6;  // that go on from a first look

struct Pair {
    const Attribution *a, *b;  ///< the better single first
    Candidate both;
    LevelFit fit;
};

/// Both effects in the order of the catalogue: edits that change the model of the joint come last.
Pair pair_of(const Attribution& a, const Attribution& b, std::size_t records)
{
    const bool swap = a.candidate.effects[0] > b.candidate.effects[0];
    const auto &first = (swap ? b : a).candidate, &second = (swap ? a : b).candidate;
    return {&a, &b, {{first.effects[0], second.effects[0]}, {first.forms[0], second.forms[0]}, records}, {}};
}

Eigen::VectorXd join(const Pair& p, const Eigen::VectorXd& of_a, const Eigen::VectorXd& of_b)
{
    const bool swap = p.both.effects[0] != p.a->candidate.effects[0];
    Eigen::VectorXd x(of_a.size() + of_b.size());
    x << (swap ? of_b : of_a), (swap ? of_a : of_b);
    return x;
}

/// A first look: from where both came to alone, and from the second started afresh on what the first leaves.
void look_at(Pair& p, const std::vector<Case>& brief, const Scales& scales, double omega)
{
    std::vector<Eigen::VectorXd> from{join(p, p.a->x[0], p.b->x[0])};
    const auto held = in_si(p.a->candidate, p.a->x[0], scales);
    double least = infinity;
    Eigen::VectorXd chosen;
    for (const auto& x : starts(brief, scales, p.b->candidate, p.a->candidate, held)) {
        const Eigen::VectorXd start = join(p, p.a->x[0], x);
        const double objective = evaluate(brief, p.both, in_si(p.both, start, scales), omega).objective;
        if (objective < least) least = objective, chosen = start;
    }
    if (chosen.size()) from.push_back(chosen);
    p.fit = best_of(brief, scales, p.both, from, omega, first_effort, first_look);
}

}  // namespace

std::vector<Attribution> fit_pairs(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                   const std::vector<Attribution>& singles, std::size_t partners,
                                   const ParallelFor& parallel)
{
    const double omega = screening_level(nominal);
    const auto brief = excerpts(cases, omega, brief_ticks, coarse);
    std::vector<Pair> simple, divided;
    for (std::size_t i = 0; i < std::min(partners, singles.size()); ++i)
        for (std::size_t j = i + 1; j < singles.size(); ++j) {
            const bool a = two_mass_edit(singles[i].candidate), b = two_mass_edit(singles[j].candidate);
            // divided masses cost ten times as much: only the best single looks for one
            if ((a && b) || (i > 0 && (a || b))) continue;
            (a || b ? divided : simple).push_back(pair_of(singles[i], singles[j], cases.size()));
        }
    std::vector<Attribution> pairs;
    const auto screen = [&](std::vector<Pair>& some, std::size_t finalists) {
        parallel(some.size(), [&](std::size_t i) { look_at(some[i], brief, scales, omega); });
        std::stable_sort(some.begin(), some.end(), [](const Pair& a, const Pair& b) {
            return a.fit.evaluation.objective < b.fit.evaluation.objective;
        });
        some.resize(std::min(finalists, some.size()));
        std::vector<Attribution> found(some.size());
        parallel(some.size(), [&](std::size_t i) {
            Pair& p = some[i];
            const int looked = p.fit.evaluations;
            p.fit = improve(brief, p.both, scales, p.fit.x, omega, full_effort);
            p.fit.evaluations += looked;
            found[i] = as_screened(cases, scales, nominal, p.both, p.fit);
        });
        pairs.insert(pairs.end(), found.begin(), found.end());
        std::stable_sort(pairs.begin(), pairs.end(), better);
        refine_best(cases, scales, nominal, pairs, refined_pairs, parallel);
    };
    screen(simple, simple_finalists);
    if (!divided.empty() && (pairs.empty() || !pairs[0].accepted)) screen(divided, divided_finalists);
    return pairs;
}

}  // namespace stickslip::gap
