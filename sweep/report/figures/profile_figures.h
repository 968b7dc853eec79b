// The charts of a sweep along a single axis.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/sweep_answer.h"

#include <vector>

namespace stickslip {

/// The spectral abscissa along the axis by both theories, with the located boundaries.
Figure profile_figure(const Joint& joint, const Profile& profile, const ProfileAnswer& answer);

/// Amplitude, period and time at rest of the limit cycles along the axis, where the sweep simulated its points.
std::vector<Figure> outcome_profiles(const Joint& joint, const Profile& profile);

}  // namespace stickslip
