// Rows that a log lost, filled in so that its clock is even again. Internal to analysis/diagnosis/records.
#pragma once
#include "analysis/diagnosis/records/record.h"

#include <cstdint>
#include <vector>

namespace stickslip::gap {

/// How many rows of a regular log each interval stands for; empty where the rows are not on such a grid.
std::vector<std::size_t> strides(const std::vector<double>& time, double step);

/// The record with rows in place of the lost ones: motion and reference go on between their neighbours, everything else
/// is unknown or, of the surroundings, as before.
Record with_lost_rows(const Record& r, const std::vector<std::size_t>& strides, std::vector<std::uint8_t>& logged);

}  // namespace stickslip::gap
