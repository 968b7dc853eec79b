#include "analysis/diagnosis/ladder/fit_set.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/policy.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stickslip::gap {
namespace {

constexpr double omega = levels[ladder_level];
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

std::vector<Window> FittedSet::all_left() const
{
    std::vector<Window> all;
    for (const auto& fold : left) all.insert(all.end(), fold.begin(), fold.end());
    return all;
}

Eigen::VectorXd FittedSet::of_member(std::size_t member) const
{
    const auto count = [&](std::size_t i) { return static_cast<Eigen::Index>(causes.count_of(*causes.forms[i])); };
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < member; ++i) at += count(i);
    return of_causes(fit.x).segment(at, count(member));
}

double FittedSet::deviations() const
{
    double sum = 0;
    for (std::size_t i = 0; i < model.numbers; ++i)
        if (const double sd = model.candidate.sd_of(i); sd > 0)
            sum += std::pow((fit.x[static_cast<Eigen::Index>(i)] - prior_mean(model.candidate, i)) / sd, 2);
    return sum;
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

void SetFitter::look(Start& s, const FittedSet& below) const
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
    if (from.empty()) return;
    const Candidate others = s.causes;
    const Eigen::VectorXd of_others = others.effects.empty() ? Eigen::VectorXd{} : below.of_causes(below.fit.x);
    insert(s.causes, s.effect, s.form, of_others, from[0]);
    const auto model = corrections_.beside(s.causes);
    const auto& part = needs_history(model.candidate) ? whole_ : brief_;
    std::vector<Eigen::VectorXd> begun;
    std::vector<std::vector<double>> si;
    for (const auto& own : from) {
        Candidate all = others;
        begun.push_back(start(s.causes, below, insert(all, s.effect, s.form, of_others, own)));
        si.push_back(in_si(model.candidate, begun.back(), scales_));
    }
    const auto looks = evaluate_all(part, model.candidate, si, {omega});
    std::map<double, std::size_t> nearest;  // start of each value that the form wants apart
    for (std::size_t i = 0; i < begun.size(); ++i) {
        if (!(looks[i].objective < infinity)) continue;
        const double value = anew && s.form->apart >= 0 ? from[i][s.form->apart] : 0;
        const auto [at, first] = nearest.try_emplace(value, i);
        if (!first && looks[i].objective < looks[at->second].objective) at->second = i;
    }
    // beside a jagged cause that is found already a descent does: a search for it anew costs five times as much
    const FitProblem problem{part, model.candidate, scales_, omega};
    std::vector<Fitting<LevelFit>> fits;
    for (const auto& [value, i] : nearest)
        fits.push_back(s.form->rough ? improving(problem, begun[i], first_effort, first_steps)
                                     : descending(problem, begun[i], first_steps));
    for (auto& found : side_by_side(std::move(fits))) {
        if (s.x0.size() > 0 && !(found.evaluation.objective < s.objective)) continue;
        s.x0 = std::move(found.x);
        s.objective = found.evaluation.objective;
    }
}

LevelFit SetFitter::near(const std::vector<Case>& cases, const Candidate& candidate, const Eigen::VectorXd& x,
                         int steps, Waves waves) const
{
    Kept kept;
    for (std::size_t i = 0; i < candidate.parameter_count() && waves == Waves::stay; ++i)
        kept.push_back(candidate.parameter(i).grid != FrequencyGrid::none);
    return descend({cases, candidate, scales_, omega}, x, steps, kept);
}

LevelFit SetFitter::rest(const Candidate& candidate, const Eigen::VectorXd& x) const
{
    if (jagged(candidate)) return improve({data_.fitted(), candidate, scales_, omega}, x, effort, steps);
    return near(data_.fitted(), candidate, x, steps, Waves::stay);
}

LevelFit SetFitter::refit(const Candidate& causes, const Eigen::VectorXd& x0) const
{
    return improve({data_.fitted(), corrections_.beside(causes).candidate, scales_, omega}, x0, effort, steps);
}

FittedSet SetFitter::fit(const Candidate& causes, const Eigen::VectorXd& x0) const
{
    return fit_folds(causes, refit(causes, x0));
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
    for (std::size_t f = 0; f < HeldOutData::folds; ++f) set.left[f] = data_.judge(f, c, in_si(c, set.x[f], scales_));
    set.misfit =
        mean_log(set.all_left()) + prior_cost(c, set.fit.x) +
        policy::price_of_parameter * static_cast<double>(set.causes.effects.empty() ? 0 : set.causes.parameter_count());
}

FittedSet SetFitter::fit_folds(Corrected model, const Candidate& causes, LevelFit found, Waves waves) const
{
    FittedSet set;
    set.causes = causes;
    set.model = std::move(model);
    set.fit = std::move(found);
    const Candidate& c = set.model.candidate;
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        set.x[f] = near(data_.without(f), c, set.fit.x, steps_of_fold, waves).x;
    judge(set);
    set.plausible = plausible(causes, set.of_causes(set.fit.x), scales_, data_.cases()[0].joint, ranges_);
    set.correction = corrections_.one_of(causes, set.of_causes(set.fit.x));
    return set;
}

}  // namespace stickslip::gap
