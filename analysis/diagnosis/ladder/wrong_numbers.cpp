// Several numbers of the document that are off at once.
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/ladder/climber.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t several = 2;  // one is a cause like any other, and is tried as one

/// A number of the document that a correction changes, as the effect of the catalogue that changes it.
struct Number {
    const Effect* effect;
    Eigen::VectorXd x;
    bool at_bound;      ///< held back by its prior
    double deviations;  ///< standard deviations from the document
    double logarithm;   ///< of the number over the documented one
};

/// The prior of a number as a part of it; 0 of a load, which is no part of anything.
double part_of(std::string_view number, const CorrectionPrior& prior)
{
    if (number == "inertia") return prior.inertia;
    if (number == "coulomb-level") return prior.coulomb;
    if (number == "viscous") return prior.viscous;
    return number == "gravity" ? prior.gravity : 0.0;
}

std::vector<Number> numbers_of(const FittedSet& set, const Corrections& corrections, const CorrectionPrior& prior)
{
    std::vector<Number> numbers;
    const Candidate& all = set.model.candidate;
    std::size_t at = 0;
    for (std::size_t i = 0; i < set.model.corrections; at += all.count_of(*all.forms[i++])) {
        const Effect* effect = effect_named(all.effects[i]->name);
        if (!effect || !corrections.same_number(*effect, effect->forms[0])) continue;
        const auto count = static_cast<Eigen::Index>(all.count_of(*all.forms[i]));
        const Candidate alone{{effect}, {&effect->forms[0]}, all.records};
        if (static_cast<Eigen::Index>(alone.parameter_count()) != count) continue;
        const double x = set.fit.x[static_cast<Eigen::Index>(at)],
                     part = x / all.sd_of(at) * part_of(effect->name, prior);
        numbers.push_back({effect, set.fit.x.segment(static_cast<Eigen::Index>(at), count),
                           Corrections::at_its_bound(all, i, at, set.fit.x),
                           Corrections::deviations(all, i, at, set.fit.x),
                           all.parameter(at).logarithmic ? x : std::log(std::max(0.1, 1 + part))});
    }
    return numbers;
}

/// The scale of the effort that brings all numbers but one nearest to the document.
double shared_scale(const std::vector<Number>& numbers, const Effect* but, const CorrectionPrior& prior)
{
    double sum = 0, weights = 0;
    for (const auto& number : numbers)
        if (const double part = part_of(number.effect->name, prior); part > 0 && number.effect != but)
            sum += number.logarithm / (part * part), weights += 1 / (part * part);
    return weights > 0 ? std::exp(-sum / weights) : 1;
}

}  // namespace

std::optional<FittedSet> Climber::wrong_numbers(const FittedSet& below, const Corrections& corrections) const
{
    const auto numbers = numbers_of(below, corrections, rules_.prior);
    if (std::ranges::count_if(numbers, &Number::at_bound) < several) return std::nullopt;
    Candidate freed = below.causes;
    freed.records = below.model.candidate.records;
    Eigen::VectorXd x = below.of_causes(below.fit.x);
    for (const auto& number : numbers) x = insert(freed, number.effect, &number.effect->forms[0], x, number.x);
    const std::size_t least = below.causes.effects.size() + several;
    FittedSet set = fitter_.fit(freed, fitter_.start(freed, below, x));
    while (set.correction && set.causes.effects.size() >= least) set = without(set, *set.correction);
    if (set.correction || !set.plausible || set.causes.effects.size() < least) return std::nullopt;
    return set;
}

std::optional<FittedSet> Climber::scaled(const FittedSet& base, const Effect* freed, const Corrections& corrections)
{
    const Effect* scale = effect_named("effort-gain");
    if (base.deviations() < rules_.relieved) return std::nullopt;
    const auto numbers = numbers_of(base, corrections, rules_.prior);
    Candidate causes = base.causes;
    causes.records = base.model.candidate.records;
    std::vector<Start> starts;
    for (const auto& form : scale->forms) {
        const Candidate alone{{scale}, {&form}, causes.records};
        if (!alone.applies(fitter_.joint()) || (form.effort_alone && !fitter_.logs_effort())) continue;
        Start start{causes};
        const double shared = shared_scale(numbers, freed, rules_.prior);
        const auto x = insert(start.causes, scale, &form, base.of_causes(base.fit.x), to_fit(alone, {shared}));
        start.x0 = fitter_.start(start.causes, base, x);
        starts.push_back(std::move(start));
    }
    const auto relieves = [&](const FittedSet& set) {
        return set.plausible && !set.correction && set.misfit < base.misfit &&
               base.deviations() - set.deviations() >= rules_.relieved;
    };
    for (const auto& set : judged(starts)) {
        if (!relieves(set)) continue;
        // along the scale only priors slope, and a first search ends on the way
        if (auto settled = compared({set}); relieves(settled)) return settled;
    }
    return std::nullopt;
}

FittedSet Climber::with_shared_scale(FittedSet set, const Corrections& corrections)
{
    const Effect* scale = effect_named("effort-gain");
    if (std::ranges::count(set.causes.effects, scale) > 0) return set;
    if (auto found = scaled(set, nullptr, corrections)) return *found;
    if (set.causes.effects.size() + several > rules_.most_rungs) return set;
    // a number that is wrong by another factor as well holds the scale back while it is a correction
    for (const auto& number : numbers_of(set, corrections, rules_.prior)) {
        if (number.deviations < rules_.far_off) continue;
        Start freed{set.causes};
        freed.causes.records = set.model.candidate.records;
        const auto x =
            insert(freed.causes, number.effect, &number.effect->forms[0], set.of_causes(set.fit.x), number.x);
        freed.x0 = fitter_.start(freed.causes, set, x);
        for (const auto& base : judged({freed}))
            if (auto found = scaled(base, number.effect, corrections); found && found->misfit < set.misfit)
                return *found;
    }
    return set;
}

}  // namespace stickslip::gap
