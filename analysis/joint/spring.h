// The force of a spring that may harden, k x + k_3 x³, its slope and its inverse.
#pragma once
#include <cmath>

namespace stickslip {

/// The springs of strain wave gears harden; a cubic polynomial fits them (Tuttle 1992, Kirćanski & Goldenberg 1997).
struct Spring {
    double stiffness = 0;  ///< N/m | N·m/rad, positive
    double cubic = 0;      ///< N/m³ | N·m/rad³, not negative

    double effort(double stretch) const { return (stiffness + cubic * stretch * stretch) * stretch; }
    double slope(double stretch) const { return stiffness + 3 * cubic * stretch * stretch; }
    /// The stretch at which the spring gives this effort: the real root of the depressed cubic, by hyperbolic
    /// functions.
    double stretch(double effort) const
    {
        if (cubic == 0) return effort / stiffness;
        const double unit = std::sqrt(stiffness / (3 * cubic));
        if (!std::isfinite(unit)) return effort / stiffness;
        return 2 * unit * std::sinh(std::asinh(1.5 * effort / (stiffness * unit)) / 3);
    }
};

}  // namespace stickslip
