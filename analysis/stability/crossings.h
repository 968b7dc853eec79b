// Every position gain at which a pair of roots crosses the imaginary axis, and the stable set in k_p.
#pragma once
#include <vector>

#include "analysis/stability/spectrum.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// All solutions ω > 0 of (34) and their k_p > 0 of (35), ascending in k_p. Complete: with u = ω², (34) is a polynomial
/// in u of degree `states`, so there are at most that many.
std::vector<Crossing> crossings(const LinearMass& mass);

/// The open intervals of k_p > 0 in which the joint is stable, decided by the spectrum between neighbouring crossings.
std::vector<Interval> stable_intervals(const LinearMass& mass, const std::vector<Crossing>& crossings);

}  // namespace stickslip
