#include "analysis/stability/integral_cost.h"

#include <algorithm>
#include <cmath>

#include "analysis/joint/gains.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/real_loop.h"

namespace stickslip {
namespace {

/// Windows in the gain of the position loop of a cascade, k_p = K_v K_pos + K_i.
std::vector<Interval> by_position_gain(std::vector<Interval> windows, const Control& c)
{
    if (c.structure == Structure::pid) return windows;
    const double K_i = velocity_integral_gain(c), K_v = c.velocity_gain;
    for (auto& w : windows) w = {(w.low - K_i) / K_v, (w.high - K_i) / K_v};
    return windows;
}

/// The gain that is turned.
double turned_gain(const Control& c)
{
    return c.structure == Structure::pid ? c.k_p : c.position_gain;
}

/// The factor to the nearer end of the window that holds the gain, less 1; outside every window to the nearest end,
/// negative.
double window_margin(const std::vector<Interval>& windows, double gain)
{
    double nearest = infinity;
    bool inside = false;
    const auto factor = [gain](double end) { return std::max(gain / end, end / gain); };
    for (const auto& w : windows) {
        inside |= gain > w.low && gain < w.high;
        if (w.low > 0) nearest = std::min(nearest, factor(w.low));
        if (w.high < infinity) nearest = std::min(nearest, factor(w.high));
    }
    return (inside ? 1 : -1) * (nearest - 1);
}

}  // namespace

std::optional<IntegralCost> integral_cost(const Joint& joint, const LinearVerdict& verdict)
{
    const Control& c = joint.control;
    if (c.kind != ControlKind::position || gains_of(c).k_i == 0 || verdict.steady.reason != Reason::none) return {};
    if (integral_at_limit(joint)) return {};
    const Joint without = without_integral(joint);
    const auto plain = linear_verdict(without);
    const double gain = turned_gain(c), gain_without = turned_gain(without.control);
    if (plain.steady.reason != Reason::none || !(gain > 0) || !(gain_without > 0)) return {};
    IntegralCost cost;
    cost.gain = gains_of(c).k_i;
    cost.without =
        window_margin(by_position_gain(plain.state_variable.stable_intervals, without.control), gain_without);
    cost.with = window_margin(by_position_gain(verdict.state_variable.stable_intervals, c), gain);
    const bool judged = cost.without > 0 && std::isfinite(cost.without) && std::isfinite(cost.with) &&
                        (cost.with > 0) == verdict.state_variable.stable;
    if (!judged) return {};
    return cost;
}

}  // namespace stickslip
