#include "analysis/diagnosis/ladder/climber.h"

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

bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below)
{
    const auto& in = other.causes.effects;
    const bool holds = std::ranges::all_of(below.effects, [&](const auto* e) { return std::ranges::count(in, e) > 0; });
    return holds && in.size() == set.causes.effects.size() && in != set.causes.effects && other.plausible &&
           !other.correction;
}

}  // namespace stickslip::gap
