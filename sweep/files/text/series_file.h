// A quantity over time from a file: a kernel, a disturbing force, a normal load.
#pragma once
#include "analysis/results/quantity.h"
#include "sweep/study/time_series.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace stickslip {

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
