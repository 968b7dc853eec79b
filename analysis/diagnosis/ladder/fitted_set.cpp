// What a fitted set tells of itself.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/ladder/ladder.h"

#include <cmath>

namespace stickslip::gap {

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

}  // namespace stickslip::gap
