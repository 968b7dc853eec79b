// Several numbers of the document that are off at once.
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/ladder/climber.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// A number of the document that a correction changes, as the effect of the catalogue that changes it.
struct Number {
    const Effect* effect;
    Eigen::VectorXd x;
    bool at_bound;  ///< held back by its prior
};

std::vector<Number> numbers_of(const FittedSet& set, const Corrections& corrections)
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
        numbers.push_back({effect, set.fit.x.segment(static_cast<Eigen::Index>(at), count),
                           Corrections::at_its_bound(all, i, at, set.fit.x)});
    }
    return numbers;
}

}  // namespace

std::size_t Climber::held_back(const FittedSet& set, const Corrections& corrections)
{
    return static_cast<std::size_t>(std::ranges::count_if(numbers_of(set, corrections), &Number::at_bound));
}

std::optional<FittedSet> Climber::wrong_numbers(const FittedSet& below, const Corrections& corrections,
                                                bool held_back) const
{
    const auto numbers = numbers_of(below, corrections);
    if (held_back && std::ranges::none_of(numbers, &Number::at_bound)) return std::nullopt;
    Candidate freed = below.causes;
    freed.records = below.model.candidate.records;
    Eigen::VectorXd x = below.of_causes(below.fit.x);
    for (const auto& number : numbers) x = insert(freed, number.effect, &number.effect->forms[0], x, number.x);
    const std::size_t stated = fitter_.of_document(below);
    const std::size_t least =
        below.causes.effects.size() + std::max<std::size_t>(1, several - std::min(several, stated));
    FittedSet set = fitter_.fit(freed, fitter_.start(freed, below, x));
    while (set.correction && set.causes.effects.size() >= least) set = without(set, *set.correction);
    if (set.correction || !set.plausible || set.causes.effects.size() < least) return std::nullopt;
    return set;
}

}  // namespace stickslip::gap
