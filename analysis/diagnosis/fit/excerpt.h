// The parts of long records that a first look at many candidates can do with.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// Cases cut down to about `budget` ticks in all, with time steps longer by `step_factor`: of every record half the
/// seconds in which the nominal joint errs most at this observer's bandwidth, half spread evenly over the rest. Every
/// piece is preceded by a part in which the observer finds the state and nothing is judged. Records keep their clock,
/// so what depends on time stays where it was. Records that are short enough stay whole.
std::vector<Case> excerpts(const std::vector<Case>& cases, double omega, std::size_t budget, double step_factor);

/// Whole records with time steps longer by `step_factor`.
std::vector<Case> uncut(std::vector<Case> cases, double step_factor);

}  // namespace stickslip::gap
