// Plain statistics of a list of numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stickslip {

/// The value that stands at this part of the sorted list, 0 the least and 1 the largest; 0 of none.
inline double percentile(std::vector<double> values, double part)
{
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The middle value, the larger of the two of an even number. Of at least one.
inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Root mean square of the finite values; 0 of none.
inline double rms(const std::vector<double>& values)
{
    double sum = 0;
    std::size_t n = 0;
    for (double v : values)
        if (std::isfinite(v)) sum += v * v, ++n;
    return n ? std::sqrt(sum / static_cast<double>(n)) : 0;
}

}  // namespace stickslip
