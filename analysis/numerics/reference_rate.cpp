#include "analysis/numerics/reference_rate.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

std::vector<std::size_t> jumps_of(const std::vector<double>& signal)
{
    std::vector<std::size_t> found;
    if (signal.size() < 4) return found;
    const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
    constexpr double least = 2e-3, alone = 4;  // of the span; of the neighbours
    const auto difference = [&](std::size_t k) { return std::abs(signal[k + 1] - signal[k]); };
    for (std::size_t k = 0; k + 1 < signal.size(); ++k) {
        const double before = k > 0 ? difference(k - 1) : 0, after = k + 2 < signal.size() ? difference(k + 1) : 0;
        if (difference(k) > std::max(least * (*high - *low), alone * std::max(before, after))) found.push_back(k);
    }
    return found;
}

std::vector<double> reference_rates(const std::vector<double>& time, const std::vector<double>& reference,
                                    const std::vector<std::size_t>& jumps, std::size_t jump_length)
{
    const std::size_t n = reference.size();
    std::vector<double> rates(n, 0.0);
    const auto jumps_between = [&](std::size_t from, std::size_t to) {
        // jumps are sorted: the last that begins before `to`
        const auto after = std::lower_bound(jumps.begin(), jumps.end(), to);
        return after != jumps.begin() && from < *(after - 1) + jump_length;
    };
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t a = k == 0 ? 0 : k - 1, b = std::min(k + 1, n - 1);
        if (jumps_between(a, k)) a = k;
        if (jumps_between(k, b)) b = k;
        if (b > a) rates[k] = (reference[b] - reference[a]) / (time[b] - time[a]);
    }
    return rates;
}

}  // namespace stickslip
