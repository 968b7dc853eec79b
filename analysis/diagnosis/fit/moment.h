// Whether what tells two causes apart is seen throughout the records or in one moment only.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <array>

namespace stickslip::gap {

/// The part of the rival's larger mean log square that hangs on one second of a record, at each level and in each
/// signal the one that speaks loudest against it; none in records of less than four. Mean squares below `least` count
/// as that. Where a joint sticks and slips a step is lost by chance, in the true joint's prediction, too, and the slow
/// observer follows late.
double hangs_on_a_moment(const std::array<Evaluation, levels.size()>& better,
                         const std::array<Evaluation, levels.size()>& rival, double least);

}  // namespace stickslip::gap
