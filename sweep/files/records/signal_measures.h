// Measures of a signal by which a record gives away its units. Internal to sweep/files/records.
#pragma once
#include <numbers>
#include <vector>
#include "analysis/results/quantity.h"

namespace stickslip::files {

inline constexpr double degrees = 180 / std::numbers::pi;

inline constexpr double near_factor = 1.3;  // two signals that agree up to noise and lag stay within this

/// Standard deviation of the values that are there.
double spread(const std::vector<double>& values);

/// The factor of a wrong unit that the ratio comes close to, or 0.
double wrong_factor(double ratio, Motion motion);

/// Central differences, as many as rows; NaN at both ends.
std::vector<double> differentiated(const std::vector<double>& time, const std::vector<double>& values);

/// How many times the rate of `values` another column of rates is, by the means of both over hundredths of the record,
/// in which noise and lag count for little; 0 where the two do not go together.
double size_of_rate(const std::vector<double>& time, const std::vector<double>& values,
                    const std::vector<double>& rates);

/// Correlation of two signals where both have values; 0 where one stands still.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stickslip::files
