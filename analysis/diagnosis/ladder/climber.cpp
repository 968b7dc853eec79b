#include "analysis/diagnosis/ladder/climber.h"

#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t near = 3;  // singles, best first
/// So many go side by side: fewer leave lanes empty, more leave threads without work at the end.
constexpr std::size_t looks_at_once = 4, sets_at_once = 3;

/// Whether the second is worse in no fold by so much that they are distinguished there, nor by a good part of what it
/// gains: a limit that one step alone reaches does nothing in the others.
bool worse_in_no_fold(const FittedSet& without, const FittedSet& with, const LadderRules& rules)
{
    const auto most = std::max(margin_of(with, rules), rules.lost_in_a_fold * (without.misfit - with.misfit));
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        if (!(mean_log(with.left[f]) < mean_log(without.left[f]) + most) && !with.left[f].empty()) return false;
    return true;
}

}  // namespace

double least_gain(const FittedSet& with, const LadderRules& rules)
{
    return std::max(rules.worth_a_rung, margin_of(with, rules));
}

double part_taken(const FittedSet& without, const FittedSet& with)
{
    const auto part = [](double before, double after) { return before > 0 ? 1 - after / before : 0; };
    const auto left = without.all_left(), now = with.all_left();
    const double of_squares = part(beyond_noise(left), beyond_noise(now));
    if (!jagged(with.causes)) return of_squares;
    return std::max(of_squares, part(std::expm1(misfit(left)), std::expm1(misfit(now))));
}

bool earns(const FittedSet& without, const FittedSet& with, const LadderRules& rules)
{
    const double gain = without.misfit - with.misfit;
    return worse_in_no_fold(without, with, rules) && gain > margin_of(with, rules) && gain > rules.worth_a_rung &&
           part_taken(without, with) > rules.of_the_rest;
}

std::vector<Start> Climber::looks(const FittedSet& below)
{
    std::vector<Start> looks;
    // divided masses cost ten times as much to judge: beside another cause only those that come near alone. With the
    // document's numbers as they are anything that mends those comes nearer: the first rung looks at all
    const auto& in = below.causes.effects;
    std::size_t causes = 0;
    for (std::size_t i = 0; i < singles_.size() && causes < rules_.first_look; ++i) {
        const Candidate& single = singles_[i].candidate;
        const bool too_dear = divides_mass(single) && i >= near && !in.empty();
        if (std::ranges::count(in, single.effects[0]) > 0 || too_dear) continue;
        ++causes;
        looks.push_back({below.causes, single.effects[0], single.forms[0], singles_[i].x});
        looks.back().causes.records = single.records;
        if (two_mass_edit(below.causes)) continue;
        for (auto& other : other_forms(below.causes, *single.effects[0], single.forms[0], single.records))
            looks.push_back(std::move(other));
    }
    for (auto& look : divided_anew(below)) looks.push_back(std::move(look));
    std::vector<Look> all;
    for (auto& start : looks) all.push_back({&start, &below});
    look_at(all);  // adds the causes
    std::stable_sort(looks.begin(), looks.end(),
                     [](const Start& a, const Start& b) { return a.objective < b.objective; });
    std::vector<const Effect*> nearer;
    std::erase_if(looks, [&](const Start& s) {
        const bool again = std::ranges::count(nearer, s.effect) > 0;
        nearer.push_back(s.effect);
        return again || s.x0.size() == 0;
    });
    if (looks.size() > rules_.finalists) looks.resize(rules_.finalists);
    return looks;
}

void Climber::look_at(std::span<const Look> looks) const
{
    std::vector<double> costs;
    for (const auto& [start, below] : looks) {
        Candidate all = below->model.candidate;
        all.effects.push_back(start->effect), all.forms.push_back(start->form);
        costs.push_back(cost_of(all));
    }
    const auto groups = in_groups(costs, looks_at_once);
    parallel_(groups.size(), [&](std::size_t g) {
        std::vector<Look> some;
        for (const std::size_t i : groups[g]) some.push_back(looks[i]);
        fitter_.look(some);
    });
}

std::vector<FittedSet> Climber::fitted(const std::vector<Start>& starts)
{
    std::vector<double> costs;
    for (const auto& start : starts) costs.push_back(cost_of(start.causes));
    const auto groups = in_groups(costs, sets_at_once);
    std::vector<FittedSet> sets(starts.size());
    parallel_(groups.size(), [&](std::size_t g) {
        std::vector<const Start*> some;
        for (const std::size_t i : groups[g]) some.push_back(&starts[i]);
        auto found = fitter_.fit_rows(some);
        for (std::size_t k = 0; k < found.size(); ++k) sets[groups[g][k]] = std::move(found[k]);
    });
    hold_out(sets);
    return sets;
}

void Climber::hold_out(std::vector<FittedSet>& sets) const
{
    std::vector<FittedSet*> rest;
    for (auto& set : sets) rest.push_back(&set);
    for (;;) {
        double limit = infinity;
        for (const auto& set : sets)
            if (set.plausible && !set.correction)
                limit = std::min(limit, set.misfit + policy::out_of_sight * margin_of(set, rules_));
        const auto far =
            std::stable_partition(rest.begin(), rest.end(), [&](const auto* set) { return set->misfit <= limit; });
        const std::vector<FittedSet*> near(rest.begin(), far);
        if (near.empty()) return;
        rest.erase(rest.begin(), far);
        std::vector<double> costs;
        for (const auto* set : near) costs.push_back(cost_of(set->causes));
        const auto groups = in_groups(costs, sets_at_once);
        parallel_(groups.size(), [&](std::size_t g) {
            std::vector<FittedSet*> some;
            for (const std::size_t i : groups[g]) some.push_back(near[i]);
            fitter_.fit_folds(some);
        });
    }
}

std::vector<Start> Climber::divided_anew(const FittedSet& below) const
{
    constexpr std::size_t most_beside = 1;  // causes but numbers of the document: more take seconds to fit
    std::vector<Start> looks;
    const std::size_t beside = below.causes.effects.size() - fitter_.of_document(below);
    if (beside > most_beside || divides_mass(below.causes)) return looks;
    for (const auto& single : singles_) {
        const Effect* effect = single.candidate.effects[0];
        const Candidate plain{{effect}, {&effect->forms[0]}, single.candidate.records};
        if (!divides_mass(plain) || !plain.applies(fitter_.joint())) continue;
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
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (sets[i].plausible) continue;
        if (starts[i].effect)
            for (auto& other : in_other_forms(sets[i], *starts[i].effect)) others.push_back(std::move(other));
        for (auto& other : in_simpler_forms(sets[i])) others.push_back(std::move(other));
    }
    for (auto& set : fitted(others)) sets.push_back(std::move(set));
    std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.misfit < b.misfit; });
    pool_.insert(pool_.end(), sets.begin(), sets.end());
    return sets;
}

/// Not of divided masses, which cost ten times as much, and not where a form has numbers of its own in every record.
std::vector<Start> Climber::other_forms(const Candidate& below, const Effect& effect, const EffectForm* than,
                                        std::size_t records) const
{
    std::vector<Start> starts;
    for (const auto& form : effect.forms) {
        const Candidate alone{{&effect}, {&form}, records};
        if (&form == than || form.own > 0 || divides_mass(alone) || !alone.applies(fitter_.joint())) continue;
        if (form.effort_alone && !fitter_.logs_effort()) continue;
        starts.push_back({below, &effect, &form});
        starts.back().causes.records = records;
    }
    return starts;
}

std::vector<Start> Climber::in_other_forms(const FittedSet& set, const Effect& effect) const
{
    const auto& effects = set.causes.effects;
    const auto member = static_cast<std::size_t>(std::ranges::find(effects, &effect) - effects.begin());
    const FittedSet below = unfitted_without(set, member);
    auto starts = other_forms(below.causes, effect, set.causes.forms[member], set.causes.records);
    std::vector<Look> looks;
    for (auto& start : starts) looks.push_back({&start, &below});
    look_at(looks);
    std::erase_if(starts, [](const Start& s) { return s.x0.size() == 0; });
    return starts;
}

FittedSet Climber::compared(const std::vector<FittedSet>& rivals)
{
    std::vector<Start> again;
    for (const auto& set : rivals) again.push_back({set.causes, nullptr, nullptr, {}, 0, set.fit.x});
    const auto sets = judged(again);
    const auto best = std::ranges::find_if(sets, [](const auto& s) { return s.plausible && !s.correction; });
    return best == sets.end() ? rivals[0] : *best;
}

}  // namespace stickslip::gap
