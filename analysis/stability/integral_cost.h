// What integral action costs of the room that the position gain has before sliding turns unstable.
#pragma once
#include <cmath>
#include <optional>

#include "analysis/stability/verdict.h"

namespace stickslip {

/// The factor from the position gain (of a cascade: the gain of its position loop) to the nearer end of its window of
/// stable gains, up or down, less 1; negative where the joint is unstable.
struct IntegralCost {
    double with = 0, without = 0;
    double gain = 0;  ///< k_i, of the sum of gains
    /// Share of the margin without the integral that it takes, both in logarithms; 1 and more: all of it.
    double share() const { return with > 0 ? 1 - std::log1p(with) / std::log1p(without) : 1 - with / without; }
};

/// Nothing where the loop does not integrate, or slides unstably without the integral, too.
std::optional<IntegralCost> integral_cost(const Joint& joint, const LinearVerdict& verdict);

}  // namespace stickslip
