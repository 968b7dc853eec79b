// The velocity that belongs to a reference of which only positions are known: one convention for who simulates a
// controller and for who reads its records.
#pragma once
#include <cstddef>
#include <vector>

namespace stickslip {

/// Where a sampled signal jumps: k for a jump between k and k + 1, far from what its neighbours change and large beside
/// the span.
std::vector<std::size_t> jumps_of(const std::vector<double>& signal);

/// At each sample the central difference, one-sided at both ends and beside a jump, since no controller differentiates
/// a step. A jump at j lies between j and j + jump_length.
std::vector<double> reference_rates(const std::vector<double>& time, const std::vector<double>& reference,
                                    const std::vector<std::size_t>& jumps, std::size_t jump_length = 1);

}  // namespace stickslip
