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

bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below)
{
    const auto& in = other.causes.effects;
    const bool holds = std::ranges::all_of(below.effects, [&](const auto* e) { return std::ranges::count(in, e) > 0; });
    return holds && in.size() == set.causes.effects.size() && in != set.causes.effects && other.plausible &&
           !other.correction;
}

}  // namespace stickslip::gap
