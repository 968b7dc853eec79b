// A loop's clock behind the time stamps of its log.
#pragma once
#include <optional>
#include <vector>

namespace stickslip::gap {

/// The times of a loop that ran evenly at the documented period, or a whole multiple of it a row, where the stamps of
/// its log scatter about them, row by row on its own: what a logger adds. Nothing where the stamps are even already,
/// where they wander off, as those of a loop do that runs unevenly, or where they scatter widely and the readings
/// follow a smoother path at the stamps than at even times.
std::optional<std::vector<double>> even_times(const std::vector<double>& stamps, const std::vector<double>& readings,
                                              double period);

}  // namespace stickslip::gap
