// Between which two ticks did the reference jump? A log slower than the loop does not say, the motion after it does.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// Places every jump of the references of slow logs at the tick after which the joint with the candidate's edits
/// predicts the next moments best. Gives whether any jump was moved.
bool settle_jumps(std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si);

}  // namespace stickslip::gap
