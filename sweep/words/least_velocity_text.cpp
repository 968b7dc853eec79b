#include "sweep/words/least_velocity_text.h"

#include "analysis/results/text.h"

#include <cmath>

namespace stickslip {

std::string least_velocity_text(double least, double lowest, Units units)
{
    if (!std::isfinite(least)) return "–";
    constexpr double end = 1 + 1e-9;
    return (least <= end * lowest ? "≤ " : "") + with_unit(least, Quantity::velocity, units);
}

}  // namespace stickslip
