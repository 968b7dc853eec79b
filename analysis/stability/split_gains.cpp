#include "analysis/stability/split_gains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/joint/steady_output.h"
#include "analysis/joint/sum_of_gains.h"

namespace stickslip {
namespace {

/// The sum of gains or the two loops of the controller.
LoopGains controller_gains(const Joint& joint)
{
    const auto& c = joint.control;
    if (c.kind == ControlKind::force) return {c.force_gain, 0, 0, 0};
    if (c.structure == Structure::pid) return {c.k_p, c.k_v, c.k_i, 0};
    const auto gains = gains_of(c);
    if (is_sum_of_gains(c)) return {gains.k_p, gains.k_v, gains.k_i, 0};
    return {c.velocity_gain * c.position_gain, c.velocity_gain, gains.k_i, velocity_integral_gain(c)};
}

/// All that the controller makes of small motions about V. A push by the velocity acts on the same estimate as k_v.
LoopGains all_gains(const Joint& joint, double velocity)
{
    auto gains = controller_gains(joint);
    if (joint.control.kind == ControlKind::position)
        gains.velocity -= push_slope(joint.control.feed_forward, joint.sensor.position_scale * velocity);
    return gains;
}

}  // namespace

std::optional<SplitGains> split(const Joint& joint, double velocity, TurnedGain turned, double towards)
{
    const auto& c = joint.control;
    LoopGains base = all_gains(joint, velocity);
    if (turned == TurnedGain::all) return SplitGains{{}, base, 1};
    if (c.kind == ControlKind::force) return {};
    if (c.structure == Structure::cascade) {
        // the gain of the position loop turns with k_p and k_i together
        if (turned == TurnedGain::k_v) return {};
        const double K_i = velocity_integral_gain(c);
        base.position -= c.velocity_gain * c.position_gain;
        base.integral = 0;
        return SplitGains{base, {c.velocity_gain, 0, K_i, 0}, c.position_gain, c.velocity_gain, K_i};
    }
    if (turned == TurnedGain::k_p) {
        base.position = 0;
        return SplitGains{base, {towards, 0, 0, 0}, towards * c.k_p, towards};
    }
    base.velocity -= c.k_v;
    return SplitGains{base, {0, towards, 0, 0}, towards * c.k_v, towards};
}

void report(const RealLoop& loop, StableGains& gains)
{
    if (loop.per_gain == 1 && loop.at_none == 0) return;
    const auto reported = [&](double gain) { return loop.at_none + loop.per_gain * gain; };
    for (auto& c : gains.crossings) c.k_p = reported(c.k_p);
    for (auto& i : gains.stable) i = {reported(i.low), reported(i.high)};
    if (std::isfinite(gains.searched_to)) gains.searched_to = reported(gains.searched_to);
    if (loop.per_gain > 0) return;
    if (std::isfinite(gains.searched_to))
        gains.searched_from = std::exchange(gains.searched_to, reported(gains.searched_from));
    for (auto& c : gains.crossings) c.direction = -c.direction;
    for (auto& i : gains.stable) std::swap(i.low, i.high);
    std::reverse(gains.stable.begin(), gains.stable.end());
    std::reverse(gains.crossings.begin(), gains.crossings.end());
}

}  // namespace stickslip
