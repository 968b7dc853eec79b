// Where a measured quantity turns within a step, from its values and slopes at both ends.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip {

/// Where in the step, 0 to 1, the cubic through m0, m1 with slopes s0, s1 over a step h turns; nothing if the slope
/// keeps its sign.
inline std::optional<double> hermite_turning(double m0, double m1, double s0, double s1, double h)
{
    if (!(s0 * s1 < 0)) return {};
    // m0 + h s0 ξ + b ξ² + c ξ³
    const double d = m1 - m0, b = 3 * d - h * (2 * s0 + s1), c = h * (s0 + s1) - 2 * d;
    const double root = std::sqrt(std::max(0.0, b * b - 3 * c * h * s0));
    const double q = -(b + std::copysign(root, b));
    const double candidates[] = {q / (3 * c), h * s0 / q};
    for (const double xi : candidates)
        if (xi >= 0 && xi <= 1) return xi;
    return {};
}

}  // namespace stickslip
