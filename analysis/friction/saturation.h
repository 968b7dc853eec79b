// What is left of a bristle that steady sliding has bent to its limit.
#pragma once
#include <cmath>
#include <limits>

namespace stickslip {

/// A difference of numbers near one, 0 where only their rounding is left: the limit itself comes out of a division and
/// its inverse, and a stiff bristle would make a spring of the last digit.
inline double unless_rounding(double difference)
{
    return std::abs(difference) > 4 * std::numeric_limits<double>::epsilon() ? difference : 0;
}

}  // namespace stickslip
