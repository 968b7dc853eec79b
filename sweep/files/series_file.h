// A quantity over time from a file: a kernel, a disturbing force, a normal load.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace stickslip {

struct Series {
    std::vector<double> time, value;  ///< s, ascending; at least two rows

    double duration() const { return time.back() - time.front(); }
    /// Means over `count` intervals of length `step` from the first row on: straight lines between the rows, the last
    /// value behind them.
    std::vector<double> sampled(double step, int count) const;
};

/// CSV or .csv.gz; `#` comments may stand above. Two columns, time [s] and the value, with or without a header; of more
/// columns the header names `time` and `column`, with or without a unit in brackets behind. Throws BadInput with the
/// place of the first row that does not fit.
Series read_series(const std::filesystem::path& file, std::string_view column);

}  // namespace stickslip
