// Disturbances of a loop that slides steadily.
#pragma once
#include "analysis/results/detail.h"
#include "analysis/results/disturbance.h"
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

#include <complex>

namespace stickslip {

/// The size that is meant where none is given, about a mode of rate s.
double small_size(DisturbanceKind kind, double V0, std::complex<double> s);

/// Why this disturbance has no meaning for a joint, whatever its size, or none.
Detail why_not_disturbed(const Joint& joint, DisturbanceKind kind);

/// Slides steadily and is then disturbed; false where that has no meaning. `joint` has the gains that act.
bool disturb_loop(SampledLoop& loop, const Joint& joint, const Disturbance& disturbance);

}  // namespace stickslip
