#include "analysis/diagnosis/audit/half_rate_filter.h"

#include "analysis/numerics/root.h"

#include <cmath>

namespace stickslip::gap {

double slope_of_noise(double g)
{
    // v_k = g n_k − g² Σ_j (1−g)^(j−1) n_{k−j}, d̄ = (n_k − n_{k−2})/2
    const double q = 1 - g, older = g * g * g / (2 - g);
    const double both = -0.5 * (g - 0.5) + (g + 0.5) * (0.5 - g * g * q) + older * q * q;
    return both / (0.25 + (g + 0.5) * (g + 0.5) + older);
}

namespace {

/// The share whose noise has this slope: that of noise falls up to shares of 0.9 and hardly changes beyond.
double share_of_noise(double slope)
{
    constexpr double steepest = 0.9;  // numerical: end of the scan
    if (slope <= slope_of_noise(steepest)) return 1;
    constexpr double precision = 1e-9;  // numerical: of the root
    const auto above = [&](double share) { return slope_of_noise(share) - slope; };
    return bracketed_root(above, 0.0, above(0), steepest, above(steepest), precision).value;
}

}  // namespace

std::optional<FilterShares> filter_shares_of_halves(const std::vector<Case>& cases)
{
    constexpr double few = 100;  // numerical: rows that give a correlation
    double both = 0, square = 0, rows = 0;
    for (const auto& c : cases) {
        const Ticks& t = c.ticks;
        for (std::size_t k = 2; k < t.size(); k += 2) {
            const double rate = (t.position[k] - t.position[k - 2]) / (2 * c.joint.control.period);
            const double before = t.velocity[k - 2] - rate, now = t.velocity[k] - rate;
            if (std::isfinite(before) && std::isfinite(now)) both += before * now, square += before * before, rows += 1;
        }
    }
    const double slope = square > 0 ? both / square : 0;
    if (rows < few || !(slope > 0 && slope < 1)) return std::nullopt;
    return FilterShares{1 - std::sqrt(slope), share_of_noise(slope)};
}

}  // namespace stickslip::gap
