// Candidates carried through all levels.
#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// Fits of one start each leave more lanes empty than those of several, but more than two would leave a thread idle.
constexpr std::size_t refined_at_once = 2;

/// What a candidate leaves in all records with the numbers of each level at each other level, and with its own where
/// that is not known: one by one, each would leave most lanes empty.
using AtEachOther = std::array<std::array<Evaluation, levels.size()>, levels.size()>;  // numbers, level

Fitting<AtEachOther> looking_at_each_other(const Fit& context, const Attribution& a)
{
    AtEachOther found;
    Asked asked{{&context.cases, &a.candidate, {}}};
    std::vector<Evaluation*> of;
    for (std::size_t from = 0; from < levels.size(); ++from)
        for (std::size_t l = 0; l < levels.size(); ++l) {
            found[from][l] = a.evaluation[l];
            if (from == l ? !a.evaluation[l].records.empty() : a.x[from] == a.x[l]) continue;
            asked.places.push_back({in_si(a.candidate, a.x[from], context.scales), levels[l]});
            of.push_back(&found[from][l]);
        }
    asked.needed = asked.places.size();
    co_await asked;
    for (std::size_t i = 0; i < of.size(); ++i) *of[i] = judged(context.cases, asked.answers[i]);
    for (std::size_t from = 0; from < levels.size(); ++from)
        for (std::size_t l = 0; l < levels.size(); ++l)
            if (a.x[from] == a.x[l]) found[from][l] = found[l][l];
    co_return found;
}

/// Carries a screened candidate through all levels, fastest first; searched on a part of the records.
Fitting<Attribution> refining(const Fit& context, const std::vector<Case>& part, Attribution a)
{
    const auto& cases = context.cases;
    const Scales& scales = context.scales;
    const Attribution screened = a;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        std::vector<Eigen::VectorXd> from{screened.x[l]};
        if (l > 0 && a.x[l - 1] != screened.x[l]) from.push_back(a.x[l - 1]);
        const FitProblem problem{part, a.candidate, scales, levels[l]};
        std::size_t start = 0;
        if (from.size() > 1) start = co_await nearest_start(problem, from);
        auto fit = co_await improving(problem, from[start], 12);
        a.evaluations += fit.evaluations;
        // the parameters of the middle bandwidth are reported: they and their errors come from all data
        const FitProblem whole{cases, a.candidate, scales, levels[l]};
        if (l == 1 && !jagged(a.candidate))
            fit = co_await descending(whole, fit.x, 1);
        else
            fit.evaluation = {};
        a.x[l] = fit.x;
        a.evaluation[l] = fit.evaluation;
        if (l == 1 && fit.information.size()) a.information = fit.information;
    }
    const AtEachOther there = co_await looking_at_each_other(context, a);
    for (std::size_t l = 0; l < levels.size(); ++l) a.evaluation[l] = there[l][l];
    // a level may have come to rest in a hollow that the others found the way out of
    std::array<std::size_t, levels.size()> numbers{0, 1, 2};  // whose each level has
    for (std::size_t l = 0; l < levels.size(); ++l)
        for (std::size_t from = 0; from < levels.size(); ++from) {
            if (a.x[from] == a.x[l]) continue;
            const Evaluation& other = there[numbers[from]][l];
            ++a.evaluations;
            if (!(other.objective < policy::out_of_the_hollow * a.evaluation[l].objective)) continue;
            a.x[l] = a.x[from], numbers[l] = numbers[from];
            a.evaluation[l] = other;
        }
    judge(a, context.nominal);
    co_return a;
}

}  // namespace

void refine_best(const Fit& fit, std::vector<Attribution>& ranked, std::size_t most)
{
    constexpr std::size_t few = 3;
    const auto part = excerpts(fit.cases, levels[1], refine_ticks, 1);
    const auto some = [&](std::size_t from, std::size_t to) {
        std::vector<Attribution*> open;
        for (std::size_t i = from; i < to; ++i)
            if (!ranked[i].refined) open.push_back(&ranked[i]);
        std::vector<double> costs;
        for (const auto* a : open) costs.push_back(cost_of(a->candidate));
        const auto groups = in_groups(costs, refined_at_once);
        fit.parallel(groups.size(), [&](std::size_t g) {
            std::vector<Fitting<Attribution>> fits;
            for (const std::size_t i : groups[g]) fits.push_back(refining(fit, part, *open[i]));
            auto found = side_by_side(std::move(fits));
            for (std::size_t k = 0; k < found.size(); ++k) {
                *open[groups[g][k]] = std::move(found[k]);
                open[groups[g][k]]->refined = true;
            }
        });
        std::stable_sort(ranked.begin(), ranked.end(), better);
    };
    most = std::min(most, ranked.size());
    some(0, std::min(few, most));
    while (most > few && !ranked.empty() && ranked[0].accepted &&
           ranked[most - 1].score > ranked[0].score + policy::far_behind)
        --most;
    some(0, most);
}

}  // namespace stickslip::gap
