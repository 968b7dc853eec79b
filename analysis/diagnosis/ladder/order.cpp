// What is asked of a set that a climb has found: in which order its causes count, and what could stand in their place.
#include "analysis/diagnosis/ladder/climber.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>

namespace stickslip::gap {

double Climber::misfit_as_documented(const FittedSet& set, const Effect& effect) const
{
    for (std::size_t i = 0; i < set.model.corrections; ++i)
        if (set.model.candidate.effects[i]->name == effect.name && set.model.candidate.forms[i]->own == 0)
            return fitter_.fit_without(set, i).misfit;
    return set.misfit;
}

double Climber::misfit_held(const FittedSet& set, std::size_t member) const
{
    FittedSet held = unfitted_without(set, member), fold = set;
    for (std::size_t f = 0; f < HeldOutData::folds; ++f) {
        fold.fit.x = set.x[f];
        held.x[f] = unfitted_without(fold, member).fit.x;
    }
    fitter_.judge(held);
    return held.misfit;
}

std::size_t Climber::last_of(const FittedSet& set, std::vector<double> lost) const
{
    std::vector<bool> usual;
    for (const Effect* cause : set.causes.effects) usual.push_back(fitter_.is_usual(set, *cause));
    if (std::ranges::count(usual, true) > 0 && std::ranges::count(usual, false) > 0)
        for (std::size_t i = 0; i < lost.size(); ++i)
            if (!usual[i]) lost[i] = infinity;
    return static_cast<std::size_t>(std::ranges::min_element(lost) - lost.begin());
}

std::vector<FittedSet> Climber::in_order(FittedSet set) const
{
    std::vector<FittedSet> order{std::move(set)};
    while (order.back().causes.effects.size() > 1) {
        const std::size_t count = order.back().causes.effects.size();
        std::vector<FittedSet> less(count);
        std::vector<double> lost(count);
        parallel_(count, [&](std::size_t i) {
            const FittedSet& whole = order.back();
            less[i] = without(whole, i);
            lost[i] = misfit_as_documented(less[i], *whole.causes.effects[i]);
            if (less[i].deviations() - whole.deviations() > policy::standing_in)
                lost[i] = std::max(lost[i], misfit_held(whole, i));
        });
        order.push_back(less[last_of(order.back(), lost)]);
    }
    std::reverse(order.begin(), order.end());
    // what takes nothing without the next cause is told with it; a small term goes alone, however little it takes
    const auto small_term_next = [&](std::size_t i) {
        const auto& below = order[i].causes.effects;
        const auto& all = order[i + 1].causes.effects;
        const auto next = std::ranges::find_if(all, [&](const auto* e) { return std::ranges::count(below, e) == 0; });
        return next != all.end() && fitter_.is_usual(order.back(), **next);
    };
    for (std::size_t i = 1; i + 1 < order.size();)
        if (small_term_next(i) || earns(order[i - 1], order[i], rules_))
            ++i;
        else
            order.erase(order.begin() + static_cast<std::ptrdiff_t>(i));
    return order;
}

std::vector<FittedSet> Climber::in_place_of(const FittedSet& set, const Candidate& below) const
{
    std::vector<FittedSet> others;
    for (const auto& other : pool_) {
        const auto& in = other.causes.effects;
        if (!may_stand_for(other, set, below)) continue;
        const auto again = std::ranges::find_if(others, [&](const auto& o) { return o.causes.effects == in; });
        if (again == others.end())
            others.push_back(other);
        else if (other.misfit < again->misfit)
            *again = other;
    }
    parallel_(others.size(), [&](std::size_t i) {
        FittedSet& other = others[i];
        // of what makes the very motion a correction of the same number is none of the cause's: gravity is documented
        // with an amplitude, and what an encoder's offset moves is its angle
        if (move_alike(set.causes, other.causes)) return;
        if (other.misfit > set.misfit + policy::out_of_question * margin_of(set, rules_)) return;
        for (const Effect* cause : set.causes.effects)
            if (std::ranges::count(below.effects, cause) + std::ranges::count(other.causes.effects, cause) == 0)
                other.misfit = std::max(other.misfit, misfit_as_documented(other, *cause));
    });
    std::ranges::stable_sort(others, {}, &FittedSet::misfit);
    return others;
}

std::optional<FittedSet> Climber::rival_in(const FittedSet& last, const Candidate& rung, const FittedSet& rival)
{
    const auto holds = [](const Candidate& c, const Effect* e) { return std::ranges::count(c.effects, e) > 0; };
    Start exchanged;
    exchanged.causes.records = last.causes.records;
    Eigen::VectorXd x;
    const auto take = [&](const FittedSet& from, auto&& wanted) {
        for (std::size_t i = 0; i < from.causes.effects.size(); ++i)
            if (wanted(from.causes.effects[i]))
                x = insert(exchanged.causes, from.causes.effects[i], from.causes.forms[i], x, from.of_member(i));
    };
    take(last, [&](const Effect* e) { return !holds(rung, e) || holds(rival.causes, e); });
    const std::size_t others = exchanged.causes.effects.size();
    take(rival, [&](const Effect* e) { return !holds(rung, e) && !holds(last.causes, e); });
    if (exchanged.causes.effects.size() == others) return std::nullopt;
    FittedSet nearest;
    const auto take_nearer = [&](const FittedSet& set) {
        if (set.plausible && !set.correction && set.misfit < nearest.misfit) nearest = set;
    };
    for (const auto& set : pool_)
        if (set.causes.effects == exchanged.causes.effects) take_nearer(set);
    if (nearest.misfit < infinity) return nearest;
    exchanged.x0 = fitter_.start(exchanged.causes, last, x);
    for (const auto& set : judged({exchanged})) take_nearer(set);
    return nearest;
}

bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below)
{
    const auto& in = other.causes.effects;
    const bool holds = std::ranges::all_of(below.effects, [&](const auto* e) { return std::ranges::count(in, e) > 0; });
    return holds && in.size() == set.causes.effects.size() && in != set.causes.effects && other.plausible &&
           !other.correction;
}

}  // namespace stickslip::gap
