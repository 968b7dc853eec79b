// What a record says between two of its rows. Internal to analysis/diagnosis/records.
#pragma once
#include <vector>

namespace stickslip::gap {

double at_or(const std::vector<double>& column, std::size_t k, double otherwise);

/// Four-point interpolation inside the row interval k … k+1 at the fraction s, linear at the ends.
double between(const std::vector<double>& x, std::size_t k, double s);

double reference_between(const std::vector<double>& x, std::size_t k, double s);

/// Rate of the same reference from its rates at the rows.
double rate_between(const std::vector<double>& x, const std::vector<double>& rate, std::size_t k, double s);

}  // namespace stickslip::gap
