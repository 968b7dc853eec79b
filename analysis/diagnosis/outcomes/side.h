// On which side of the boundary between smooth sliding and stick-slip a joint lies, and how far from it.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip::gap {

/// Beyond this relative change of a setting a row counts as far from the boundary.
inline constexpr double farthest = 3;  // numerical: five times the widest softness, where a probability is 0.99

/// Least velocity, in V_0, on the first turn after a mass has broken loose under a static law, the friction below zero
/// velocity continued as that of just above: positive if it slides on, zero if it just touches rest, negative if it
/// comes to rest and sticks. By uniqueness in the plane of spring force and velocity the first turn decides: a mass
/// that sticks again breaks loose at the same point. Single mass, V_0 > 0.
double least_velocity_after_release(const Joint& joint);

/// Signed distance from the boundary as a relative change of k_p, k_v and V_0 together (first order: measure over the
/// length of its gradient in the logarithms): positive where the joint sticks and slips, within ±`farthest`. Static
/// laws count as stick-slip where small disturbances grow or where a start from rest comes to rest again; laws with
/// memory by their linear growth. NaN where there is no steady sliding.
double distance_to_stick_slip(const Joint& joint);

}  // namespace stickslip::gap
