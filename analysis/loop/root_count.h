// How many roots of a delayed loop lie right of a vertical line: the argument principle.
#pragma once
#include <optional>

#include "analysis/loop/opened_loop.h"

namespace stickslip {

/// Those of the opened loop and the turns of 1 + L. Nothing where a root lies on the line. `nearest`: how near one may
/// be. The imaginary axis is left by an arc around the integrators at s = 0, several of which rounding moves to either
/// side; no root of 1 + L lies within the arc where |L| is large on it. With `looked`, the frequencies of the line at
/// which the loop was looked at, and how fast it turns there.
struct LookedAt {
    double omega, steepness;
};
std::optional<int> roots_right_of(const OpenedLoop& open, double gain, double sigma, double nearest = infinity,
                                  std::vector<LookedAt>* looked = nullptr);

}  // namespace stickslip
