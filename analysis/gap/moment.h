// Whether what tells two causes apart is seen throughout the records or in one moment only.
#pragma once
#include "analysis/gap/fit.h"

#include <array>

namespace stickslip::gap {

/// The part of the rival's larger mean log square that hangs on the one second of each record, at each level, that
/// speaks loudest against it. Where a joint sticks and slips a step is lost by chance, in the true joint's prediction,
/// too, and the slow observer follows late.
double hangs_on_a_moment(const std::array<Evaluation, levels.size()>& better,
                         const std::array<Evaluation, levels.size()>& rival);

}  // namespace stickslip::gap
