// Sampled curves: where to sample, and where to sample again because a line would show corners.
#pragma once
#include <functional>
#include <vector>

namespace stickslip {

/// y over x in SI; NaN where there is none.
struct Samples {
    std::vector<double> x, y;
};

/// `count` values from low to high, evenly in the logarithm.
std::vector<double> log_steps(double low, double high, int count);

/// The values of an axis, both ends included and exact. Needs from < to, and from > 0 for a log scale.
std::vector<double> spaced(double from, double to, std::size_t points, bool log);

/// Adds samples of y(x) to a line over a logarithmic axis where neighbours lie so far apart that it would show corners,
/// and where it begins, ends or falls to zero. `most`: what ln y may change by from sample to sample.
void smooth(Samples& line, const std::function<double(double)>& y, double most = 0.15, int rounds = 6);

}  // namespace stickslip
