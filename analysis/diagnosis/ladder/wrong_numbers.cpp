// Several numbers of the document that are off at once.
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/ladder/climber.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t several = 2;  // one is a cause like any other, and is tried as one

struct Freed {
    Candidate causes;
    Eigen::VectorXd x;
    std::size_t at_bound = 0;  ///< how many of them their prior held back
};

/// Every number of the document that corrections change, as the effect of the catalogue that changes it.
Freed freed_numbers(const FittedSet& below, const Corrections& corrections)
{
    const Candidate& all = below.model.candidate;
    Freed freed{below.causes, below.of_causes(below.fit.x)};
    freed.causes.records = all.records;
    std::size_t at = 0;
    for (std::size_t i = 0; i < below.model.corrections; at += all.count_of(*all.forms[i++])) {
        const Effect* effect = effect_named(all.effects[i]->name);
        if (!effect || !corrections.same_number(*effect, effect->forms[0])) continue;
        const auto count = static_cast<Eigen::Index>(all.count_of(*all.forms[i]));
        const Candidate alone{{effect}, {&effect->forms[0]}, all.records};
        if (static_cast<Eigen::Index>(alone.parameter_count()) != count) continue;
        freed.x = insert(freed.causes, effect, &effect->forms[0], freed.x,
                         below.fit.x.segment(static_cast<Eigen::Index>(at), count));
        freed.at_bound += Corrections::at_its_bound(all, i, at, below.fit.x) ? 1 : 0;
    }
    return freed;
}

}  // namespace

std::optional<FittedSet> Climber::wrong_numbers(const FittedSet& below, const Corrections& corrections) const
{
    const Freed freed = freed_numbers(below, corrections);
    const std::size_t least = below.causes.effects.size() + several;
    if (freed.at_bound < several) return std::nullopt;
    FittedSet set = fitter_.fit(freed.causes, fitter_.start(freed.causes, below, freed.x));
    while (set.correction && set.causes.effects.size() >= least) set = without(set, *set.correction);
    if (set.correction || !set.plausible || set.causes.effects.size() < least) return std::nullopt;
    return set;
}

}  // namespace stickslip::gap
