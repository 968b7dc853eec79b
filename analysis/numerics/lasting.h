// Numbers that fluctuate, and whether they go on doing so.
#pragma once
#include <vector>

namespace stickslip {

/// Whether these sizes go on as they are: the later half has the mean and the spread of the earlier one. What drifts,
/// fades or is too short to be judged does not.
bool lasts(const std::vector<double>& sizes);

}  // namespace stickslip
