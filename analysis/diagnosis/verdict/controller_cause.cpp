#include "analysis/diagnosis/verdict/controller_cause.h"

#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/verdict/chances.h"

#include <algorithm>
#include <utility>

namespace stickslip::gap {

void put_controller_in_order(Cause controller, const JudgedLadder& j, Diagnosis& d)
{
    if (d.ladder.empty() || d.effects.empty()) return;
    double beside = 0, sum = 0;
    for (std::size_t i = 1; i < d.ladder.size(); ++i) beside += d.ladder[i].share;
    for (const auto& c : d.effects) sum += c.probability;
    const Shares& s = j.shares;
    const bool explains = !s.rungs.empty() && s.rungs.back() < policy::nearest_in_shape * s.base;
    const double least = explains && !j.usual ? policy::least_beside_finding : policy::least_against_corrections;
    // an encoder's coarser steps take nothing of the gap that they make, and corrections are no causes beside them
    const bool good_part =
        beside > 0 && (beside >= least * d.ladder[0].share || (j.noise_left && only_stated_numbers(j.ladder)));
    if (good_part && j.noise_left) return;
    // whichever of the others acts beside it, it is not alone
    if (good_part && sum > policy::finding_and_more) {
        controller.probability = std::max(0.0, 1 - sum);
        const auto less = std::find_if(d.effects.begin(), d.effects.end(),
                                       [&](const Cause& c) { return c.probability <= controller.probability; });
        d.effects.insert(less, std::move(controller));
        return;
    }
    // numbers of the document are no cause beside it: it is alone where they are all that is off
    controller.probability = j.noise_left         ? 1 - policy::doubt_of_noise
                             : j.only_corrections ? policy::finding_with_numbers
                                                  : policy::finding_and_more;
    for (auto& c : d.effects) c.probability *= 1 - controller.probability;
    d.effects.insert(d.effects.begin(), std::move(controller));
}

}  // namespace stickslip::gap
