// Exact one-sided bounds of a share that was counted: Clopper and Pearson 1934.
#pragma once
#include <algorithm>
#include <cmath>

namespace stickslip::blind {

/// Chance of `least` or more hits in `of` tries of this share.
inline double chance_of_at_least(int least, int of, double share)
{
    if (least <= 0) return 1;
    if (share <= 0) return 0;
    if (share >= 1) return 1;
    double sum = 0;
    for (int k = least; k <= of; ++k)
        sum += std::exp(std::lgamma(of + 1.0) - std::lgamma(k + 1.0) - std::lgamma(of - k + 1.0) + k * std::log(share) +
                        (of - k) * std::log1p(-share));
    return std::min(sum, 1.0);
}

/// The share that so many hits or more would reach in one of twenty counts: the true share is at least that, with a
/// confidence of 95 %.
inline double share_at_least(int right, int of, double confidence = 0.95)
{
    if (right <= 0) return 0;
    double low = 0, high = 1;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (chance_of_at_least(right, of, middle) < 1 - confidence ? low : high) = middle;
    }
    return low;
}

/// The same from above.
inline double share_at_most(int right, int of, double confidence = 0.95)
{
    return 1 - share_at_least(of - right, of, confidence);
}

}  // namespace stickslip::blind
