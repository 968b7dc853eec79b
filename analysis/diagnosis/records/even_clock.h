// A loop's clock behind the time stamps of its log.
#pragma once
#include <optional>
#include <vector>

namespace stickslip::gap {

/// The times of a loop that ran evenly at the documented period, or a whole multiple of it a row, where the stamps of
/// its log scatter about them, row by row on its own: what a logger adds. Nothing where the stamps are even already, or
/// where they wander off, as those of a loop do that runs unevenly.
std::optional<std::vector<double>> even_times(const std::vector<double>& stamps, double period);

}  // namespace stickslip::gap
