// A quantity over time from a file: a kernel, a disturbing force, a normal load.
#pragma once
#include "analysis/results/quantity.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace stickslip {

struct TimeSeries {
    std::vector<double> time, value;  ///< s, ascending; at least two rows

    double duration() const { return time.back() - time.front(); }
    /// Means over `count` intervals of length `step` from the first row on: straight lines between the rows, the last
    /// value behind them.
    std::vector<double> sampled(double step, int count) const;
};

/// What a column of a series holds, so that a unit in its header can be converted.
struct SeriesQuantity {
    Quantity quantity;
    Units units;
};

/// CSV or .csv.gz; `#` comments may stand above. Two columns, time [s] and the value, with or without a header; of more
/// columns the header names `time` and `column`. A unit in brackets behind a name is converted ("time [ms]"); without
/// a `quantity` that of the value is left as it is. Throws BadInput with the place of the first row that does not fit.
TimeSeries read_series(const std::filesystem::path& file, std::string_view column,
                       std::optional<SeriesQuantity> quantity = std::nullopt);

}  // namespace stickslip
