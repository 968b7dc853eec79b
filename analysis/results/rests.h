// Which points of a map come to rest for good where they do not slide on, read off their numbers.
#pragma once
#include "analysis/results/stability_map.h"

#include <cstddef>
#include <vector>

namespace stickslip {

/// A motion that ends at rest for good rests all of the time and has no period: NonlinearVerdict::comes_to_rest, from
/// columns of results.nc. Empty where the sweep simulated nothing.
inline std::vector<bool> rests_of(const std::vector<MapReading>& readings)
{
    const MapReading *still = nullptr, *period = nullptr;
    for (const auto& reading : readings) {
        if (reading.column == "stick_fraction") still = &reading;
        if (reading.column == "period") period = &reading;
    }
    std::vector<bool> rests;
    if (!still || !period) return rests;
    for (std::size_t i = 0; i < still->values.size(); ++i)
        rests.push_back(still->values[i] == 1 && period->values[i] != period->values[i]);
    return rests;
}

}  // namespace stickslip
