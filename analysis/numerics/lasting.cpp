#include "analysis/numerics/lasting.h"

#include <cmath>
#include <numeric>

namespace stickslip {
namespace {

constexpr std::size_t fewest_to_last = 16;  ///< turns whose halves are compared
constexpr double same_mean = 3;             ///< difference of the means of halves, per the error of such a difference
constexpr double same_spread = 2;           ///< ratio of the spreads of halves: ten turns of each give it to a quarter

}  // namespace

bool lasts(const std::vector<double>& sizes)
{
    if (sizes.size() < fewest_to_last) return false;
    const auto half = static_cast<std::ptrdiff_t>(sizes.size() / 2);
    const auto n = static_cast<double>(half);
    struct Half {
        double mean = 0, spread = 0;
    };
    const auto measure = [n](auto from, auto to) {
        Half h;
        h.mean = std::accumulate(from, to, 0.0) / n;
        for (auto s = from; s != to; ++s) h.spread += (*s - h.mean) * (*s - h.mean) / (n - 1);
        h.spread = std::sqrt(h.spread);
        return h;
    };
    const Half before = measure(sizes.end() - 2 * half, sizes.end() - half),
               now = measure(sizes.end() - half, sizes.end());
    const double error = std::hypot(before.spread, now.spread) / std::sqrt(n);
    return std::abs(now.mean - before.mean) < same_mean * error && now.spread * same_spread > before.spread &&
           before.spread * same_spread > now.spread;
}

}  // namespace stickslip
