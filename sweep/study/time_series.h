// A quantity over time: a kernel, a disturbing force, a normal load.
#pragma once
#include <vector>

namespace stickslip {

struct TimeSeries {
    std::vector<double> time, value;  ///< s, ascending; at least two rows

    double duration() const { return time.back() - time.front(); }
    /// Means over `count` intervals of length `step` from the first row on: straight lines between the rows, the last
    /// value behind them.
    std::vector<double> sampled(double step, int count) const;
};

}  // namespace stickslip
