#include "analysis/diagnosis/ladder/fit_set.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stickslip::gap {
namespace {

constexpr double omega = levels[ladder_level];                // numerical: rad/s
constexpr int first_steps = 3, steps = 6, steps_of_fold = 3;  // of descents
constexpr int first_effort = 6, effort = 15;  // evaluations a parameter of searches for what the misfit is jagged in

}  // namespace

Eigen::VectorXd insert(Candidate& causes, const Effect* effect, const EffectForm* form, const Eigen::VectorXd& numbers,
                       const Eigen::VectorXd& of_effect)
{
    std::size_t place = 0;
    Eigen::Index at = 0;
    while (place < causes.effects.size() && causes.effects[place] < effect)
        at += static_cast<Eigen::Index>(causes.count_of(*causes.forms[place++]));
    causes.effects.insert(causes.effects.begin() + static_cast<std::ptrdiff_t>(place), effect);
    causes.forms.insert(causes.forms.begin() + static_cast<std::ptrdiff_t>(place), form);
    Eigen::VectorXd x(numbers.size() + of_effect.size());
    x.head(at) = numbers.head(at);
    x.segment(at, of_effect.size()) = of_effect;
    x.tail(numbers.size() - at) = numbers.tail(numbers.size() - at);
    return x;
}

void SetFitter::renew()
{
    brief_ = excerpts(data_.fitted(), omega, brief_ticks, coarse);
    whole_ = uncut(data_.fitted(), coarse);
}

Eigen::VectorXd SetFitter::start(const Candidate& causes, const FittedSet& like, const Eigen::VectorXd& of_causes) const
{
    return Corrections::start(corrections_.beside(causes), like.model, like.fit.x, of_causes);
}

FittedSet SetFitter::unfitted(const Candidate& causes, const FittedSet& like, const Eigen::VectorXd& of_causes) const
{
    FittedSet set;
    set.causes = causes;
    set.model = corrections_.beside(causes);
    set.fit.x = start(causes, like, of_causes);
    return set;
}

std::vector<Fitting<LevelFit>> SetFitter::begun(Start& s, const FittedSet& below, Corrected& model) const
{
    const Candidate added{{s.effect}, {s.form}, s.causes.records};
    std::vector<Eigen::VectorXd> from;
    for (const auto& numbers : s.alone)
        if (numbers.size() > 0) from.push_back(numbers);
    const bool anew = from.empty();
    if (anew || !divides_mass(added)) {
        const auto si = in_si(below.model.candidate, below.fit.x, scales_);
        for (auto& seed : starts(data_.fitted(), scales_, added, below.model.candidate, si))
            from.push_back(std::move(seed));
    }
    std::erase_if(from,
                  [&](const auto& own) { return own.size() != static_cast<Eigen::Index>(added.parameter_count()); });
    if (from.empty()) return {};
    const Candidate others = s.causes;
    const Eigen::VectorXd of_others = others.effects.empty() ? Eigen::VectorXd{} : below.of_causes(below.fit.x);
    insert(s.causes, s.effect, s.form, of_others, from[0]);
    model = corrections_.beside(s.causes);
    const auto& part = needs_history(model.candidate) ? whole_ : brief_;
    std::vector<Eigen::VectorXd> at;
    std::vector<std::vector<double>> si;
    for (const auto& own : from) {
        Candidate all = others;
        at.push_back(start(s.causes, below, insert(all, s.effect, s.form, of_others, own)));
        si.push_back(in_si(model.candidate, at.back(), scales_));
    }
    const auto looks = evaluate_all(part, model.candidate, si, {omega});
    std::map<double, std::size_t> nearest;  // start of each value that the form wants apart
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!(looks[i].objective < infinity)) continue;
        const double value = anew && s.form->apart >= 0 ? from[i][s.form->apart] : 0;
        const auto [best, first] = nearest.try_emplace(value, i);
        if (!first && looks[i].objective < looks[best->second].objective) best->second = i;
    }
    // beside a jagged cause that is found already a descent does: a search for it anew costs five times as much
    const FitProblem problem{part, model.candidate, scales_, omega};
    std::vector<Fitting<LevelFit>> fits;
    for (const auto& [value, i] : nearest)
        fits.push_back(s.form->rough ? improving(problem, at[i], first_effort, first_steps)
                                     : descending(problem, at[i], first_steps));
    return fits;
}

void SetFitter::look(std::span<const Look> looks) const
{
    std::vector<Corrected> models(looks.size());
    std::vector<Fitting<LevelFit>> fits;
    std::vector<Start*> of;
    for (std::size_t i = 0; i < looks.size(); ++i)
        for (auto& fit : begun(*looks[i].start, *looks[i].below, models[i]))
            fits.push_back(std::move(fit)), of.push_back(looks[i].start);
    auto found = side_by_side(std::move(fits));
    for (std::size_t k = 0; k < found.size(); ++k) {
        Start& s = *of[k];
        if (s.x0.size() > 0 && !(found[k].evaluation.objective < s.objective)) continue;
        s.x0 = std::move(found[k].x);
        s.objective = found[k].evaluation.objective;
    }
}

Fitting<LevelFit> SetFitter::near(const std::vector<Case>& cases, const Candidate& candidate, const Eigen::VectorXd& x,
                                  int steps, Waves waves) const
{
    Kept kept;
    for (std::size_t i = 0; i < candidate.parameter_count() && waves == Waves::stay; ++i)
        kept.push_back(candidate.parameter(i).grid != FrequencyGrid::none);
    return descending({cases, candidate, scales_, omega}, x, steps, kept);
}

LevelFit SetFitter::rest(const Candidate& candidate, const Eigen::VectorXd& x) const
{
    if (jagged(candidate)) return improve({data_.fitted(), candidate, scales_, omega}, x, effort, steps);
    return alone(near(data_.fitted(), candidate, x, steps, Waves::stay));
}

LevelFit SetFitter::refit(const Candidate& causes, const Eigen::VectorXd& x0) const
{
    return improve({data_.fitted(), corrections_.beside(causes).candidate, scales_, omega}, x0, effort, steps);
}

FittedSet SetFitter::fit(const Candidate& causes, const Eigen::VectorXd& x0) const
{
    return fit_folds(causes, refit(causes, x0));
}

std::vector<FittedSet> SetFitter::fit_rows(std::span<const Start* const> starts) const
{
    std::vector<Corrected> models;
    for (const auto* s : starts) models.push_back(corrections_.beside(s->causes));
    std::vector<Fitting<LevelFit>> fits;
    for (std::size_t i = 0; i < starts.size(); ++i)
        fits.push_back(improving({data_.fitted(), models[i].candidate, scales_, omega}, starts[i]->x0, effort, steps));
    auto found = side_by_side(std::move(fits));
    std::vector<FittedSet> sets;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        sets.push_back(found_set(std::move(models[i]), starts[i]->causes, std::move(found[i])));
        sets[i].x.fill(sets[i].fit.x);
        judge(sets[i]);
    }
    return sets;
}

void SetFitter::fit_folds(std::span<FittedSet* const> sets) const
{
    fit_folds(sets, Waves::move);
}

FittedSet SetFitter::fit_folds(const Candidate& causes, LevelFit found) const
{
    return fit_folds(corrections_.beside(causes), causes, std::move(found), Waves::move);
}

FittedSet SetFitter::fit_rest(const Candidate& causes, const Eigen::VectorXd& x0) const
{
    Corrected model = corrections_.beside(causes);
    auto found = rest(model.candidate, x0);
    return fit_folds(std::move(model), causes, std::move(found), Waves::stay);
}

FittedSet SetFitter::fit_without(const FittedSet& set, std::size_t correction) const
{
    Corrected model = Corrections::but(set.model, correction);
    const auto x0 = Corrections::start(model, set.model, set.fit.x, set.of_causes(set.fit.x));
    auto found = rest(model.candidate, x0);
    return fit_folds(std::move(model), set.causes, std::move(found), Waves::stay);
}

void SetFitter::judge(FittedSet& set) const
{
    const Candidate& c = set.model.candidate;
    std::array<std::vector<double>, HeldOutData::folds> si;
    for (std::size_t f = 0; f < HeldOutData::folds; ++f) si[f] = in_si(c, set.x[f], scales_);
    set.left = data_.judge(c, si);
    set.misfit =
        mean_log(set.all_left()) + prior_cost(c, set.fit.x) +
        policy::price_of_parameter * static_cast<double>(set.causes.effects.empty() ? 0 : set.causes.parameter_count());
    const auto of_causes = set.of_causes(set.fit.x);
    set.plausible = plausible(set.causes, of_causes, scales_, data_.cases()[0].joint, ranges_);
    set.correction = corrections_.one_of(set.causes, of_causes);
}

FittedSet SetFitter::found_set(Corrected model, const Candidate& causes, LevelFit found) const
{
    FittedSet set;
    set.causes = causes;
    set.model = std::move(model);
    set.fit = std::move(found);
    return set;
}

FittedSet SetFitter::fit_folds(Corrected model, const Candidate& causes, LevelFit found, Waves waves) const
{
    FittedSet set = found_set(std::move(model), causes, std::move(found));
    FittedSet* const one[] = {&set};
    fit_folds(one, waves);
    return set;
}

void SetFitter::fit_folds(std::span<FittedSet* const> sets, Waves waves) const
{
    std::vector<Fitting<LevelFit>> folds;
    for (const auto* set : sets)
        for (std::size_t f = 0; f < HeldOutData::folds; ++f)
            folds.push_back(near(data_.without(f), set->model.candidate, set->fit.x, steps_of_fold, waves));
    const auto found = side_by_side(std::move(folds));
    auto fold = found.begin();
    for (auto* set : sets) {
        for (auto& x : set->x) x = (fold++)->x;
        judge(*set);
    }
}

}  // namespace stickslip::gap
