// Shares of a whole with intervals: how much of the excess misfit each stage or regime holds.
#pragma once
#include "analysis/results/diagnosis.h"

#include <vector>

namespace stickslip::gap {

inline constexpr double block_seconds = 1;  ///< numerical: resampled as a whole, since neighbours are correlated

/// Sums of one block: excess square of each stage or regime.
using Block = std::vector<double>;

/// Fills share and interval of every entry: its excess over that of the first `whole` entries together. The interval
/// (2.5 to 97.5 %) is a bootstrap over blocks with a fixed sequence.
void add_shares(std::vector<Share>& shares, const std::vector<Block>& blocks, std::size_t whole);

}  // namespace stickslip::gap
