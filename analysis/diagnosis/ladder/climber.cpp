#include "analysis/diagnosis/ladder/climber.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// Whether the second is worse in no fold by so much that they are distinguished there, nor by a good part of what it
/// gains: a limit that one step alone reaches does nothing in the others.
bool worse_in_no_fold(const FittedSet& without, const FittedSet& with, const LadderRules& rules)
{
    const double most = std::max(margin_of(with, rules), rules.lost_in_a_fold * (without.misfit - with.misfit));
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        if (!(mean_log(with.left[f]) < mean_log(without.left[f]) + most) && !with.left[f].empty()) return false;
    return true;
}

}  // namespace

bool earns(const FittedSet& without, const FittedSet& with, const LadderRules& rules)
{
    const double left = beyond_noise(without.all_left()), now = beyond_noise(with.all_left());
    const double beyond = std::max(rules.worth_a_rung, margin_of(with, rules));
    return worse_in_no_fold(without, with, rules) && without.misfit - with.misfit > beyond &&
           left - now > rules.of_the_rest * left;
}

std::vector<FittedSet> Climber::fitted(const std::vector<Start>& starts)
{
    std::vector<FittedSet> sets(starts.size());
    parallel_(starts.size(), [&](std::size_t i) { sets[i] = fitter_.fit(starts[i].causes, starts[i].x0); });
    return sets;
}

std::vector<Start> Climber::divided_anew(const FittedSet& below) const
{
    constexpr std::size_t most_beside = 1;  // causes: with more of them a set takes seconds to fit
    std::vector<Start> looks;
    if (below.causes.effects.size() > most_beside || two_mass_edit(below.causes)) return looks;
    for (const auto& single : singles_) {
        const Effect* effect = single.candidate.effects[0];
        const Candidate plain{{effect}, {&effect->forms[0]}, single.candidate.records};
        if (plain.forms[0]->apart < 0 || !two_mass_edit(plain) || !plain.applies(fitter_.joint())) continue;
        looks.push_back({below.causes, effect, plain.forms[0]});
        looks.back().causes.records = plain.records;
    }
    return looks;
}

std::vector<FittedSet> Climber::judged(const std::vector<Start>& starts)
{
    auto sets = fitted(starts);
    // a form whose numbers stand at their bounds says with more of them what a simpler one says
    std::vector<Start> others;
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (starts[i].effect && !sets[i].plausible)
            for (auto& other : in_other_forms(sets[i], *starts[i].effect)) others.push_back(std::move(other));
    for (auto& set : fitted(others)) sets.push_back(std::move(set));
    std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.misfit < b.misfit; });
    pool_.insert(pool_.end(), sets.begin(), sets.end());
    return sets;
}

/// Not of divided masses, which cost ten times as much, and not where a form has numbers of its own in every record.
std::vector<Start> Climber::in_other_forms(const FittedSet& set, const Effect& effect) const
{
    const auto& effects = set.causes.effects;
    const auto member = static_cast<std::size_t>(std::ranges::find(effects, &effect) - effects.begin());
    const FittedSet below = unfitted_without(set, member);
    std::vector<Start> starts;
    for (const auto& form : effect.forms) {
        const Candidate alone{{&effect}, {&form}, set.causes.records};
        if (&form == set.causes.forms[member] || form.own > 0 || two_mass_edit(alone) ||
            !alone.applies(fitter_.joint()))
            continue;
        Start start{below.causes, &effect, &form};
        start.causes.records = set.causes.records;
        fitter_.look(start, below);
        if (start.x0.size() > 0) starts.push_back(std::move(start));
    }
    return starts;
}

FittedSet Climber::flexed(FittedSet set)
{
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
        const auto starts = with_flexible_member(set, i);
        if (starts.empty()) continue;
        FittedSet more = judged(starts)[0];
        if (more.plausible && earns(set, more, rules_)) set = std::move(more);
    }
    return set;
}

std::vector<Start> Climber::with_flexible_member(const FittedSet& set, std::size_t member) const
{
    const Effect& effect = *set.causes.effects[member];
    if (effect.flexible.empty() || set.causes.forms[member] != &effect.forms[0]) return {};
    const EffectForm& form = effect.flexible[0];
    const FittedSet others = unfitted_without(set, member);
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < member; ++i) at += static_cast<Eigen::Index>(set.causes.count_of(*set.causes.forms[i]));
    const auto count = static_cast<Eigen::Index>(effect.forms[0].parameters.size());
    Eigen::VectorXd own = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(form.parameters.size()));
    own.head(count) = set.of_causes(set.fit.x).segment(at, count);
    std::vector<Start> starts;
    const auto add = [&](const Eigen::VectorXd& numbers) {
        Candidate causes = others.causes;
        const Eigen::VectorXd x = insert(causes, &effect, &form, others.of_causes(others.fit.x), numbers);
        starts.push_back({causes, nullptr, nullptr, {}, 0, fitter_.start(causes, set, x)});
    };
    add(own);
    constexpr Eigen::Index sizes = 2;  // sine and cosine, in front of the number of periods and behind it
    Eigen::VectorXd longer = own;
    longer.tail(sizes) = own.head(sizes), longer.head(sizes).setZero();
    longer[sizes] -= std::log(2.0);
    add(longer);
    return starts;
}

double Climber::misfit_as_documented(const FittedSet& set, const Effect& effect) const
{
    for (std::size_t i = 0; i < set.model.corrections; ++i)
        if (set.model.candidate.effects[i]->name == effect.name && set.model.candidate.forms[i]->own == 0)
            return fitter_.fit_without(set, i).misfit;
    return set.misfit;
}

std::vector<FittedSet> Climber::in_order(FittedSet set) const
{
    std::vector<FittedSet> order{std::move(set)};
    while (order.back().causes.effects.size() > 1) {
        const std::size_t count = order.back().causes.effects.size();
        std::vector<FittedSet> less(count);
        std::vector<double> lost(count);
        parallel_(count, [&](std::size_t i) {
            less[i] = without(order.back(), i);
            lost[i] = misfit_as_documented(less[i], *order.back().causes.effects[i]);
        });
        order.push_back(less[static_cast<std::size_t>(std::ranges::min_element(lost) - lost.begin())]);
    }
    std::reverse(order.begin(), order.end());
    return order;
}

std::vector<FittedSet> Climber::in_place_of(const FittedSet& set, const Candidate& below) const
{
    constexpr double out_of_question = 4;  // margins, at which odds are 0.02
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
        if (other.misfit > set.misfit + out_of_question * margin_of(set, rules_)) return;
        for (const Effect* cause : set.causes.effects)
            if (std::ranges::count(below.effects, cause) + std::ranges::count(other.causes.effects, cause) == 0)
                other.misfit = std::max(other.misfit, misfit_as_documented(other, *cause));
    });
    std::ranges::stable_sort(others, {}, &FittedSet::misfit);
    return others;
}

bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below)
{
    const auto& in = other.causes.effects;
    const bool holds = std::ranges::all_of(below.effects, [&](const auto* e) { return std::ranges::count(in, e) > 0; });
    return holds && in.size() == set.causes.effects.size() && in != set.causes.effects && other.plausible &&
           !other.correction;
}

}  // namespace stickslip::gap
