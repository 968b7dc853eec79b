#include "analysis/stability/stable_gains.h"

#include <algorithm>

#include "analysis/stability/crossings.h"
#include "analysis/stability/gain_scan.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

bool same(const LinearFriction& a, const LinearFriction& b)
{
    if (a.f_v != b.f_v || a.states != b.states || a.delays.size != b.delays.size || a.table != b.table) return false;
    for (int i = 0; i < a.states; ++i)
        if (a.lambda[i] != b.lambda[i] || a.b[i] != b.b[i] || a.h[i] != b.h[i]) return false;
    return std::equal(a.delays.begin(), a.delays.end(), b.delays.begin(),
                      [](const auto& x, const auto& y) { return x.weight == y.weight && x.time == y.time; });
}

}  // namespace

void take_single_gain(StableGains& gains)
{
    // the gain that just holds a pushing contact is critical only where no oscillation asks for more
    const auto& stable = gains.stable;
    const auto swinging = std::ranges::count_if(gains.crossings, [](const Crossing& c) { return c.omega > 0; });
    if (gains.crossings.empty() || (gains.crossings.size() > 1 && swinging > 1)) return;
    const Crossing& last = gains.crossings.back();
    if (stable.size() != 1 || stable[0].low != last.k_p) return;
    gains.k_cr = last.k_p;
    gains.omega = last.omega;
}

bool gain_moves_sliding(const Joint& joint)
{
    if (joint.control.kind != ControlKind::force || !(joint.control.k_p > 0)) return false;
    const double V = commanded_velocity(joint);
    const bool ramp = is_set(joint.control.force_rate);
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i) {
        if (!ramp && i == chain.bodies - 1) continue;  // the link slides at V_0 whatever the gain
        const auto& friction = *chain.body[i].friction;
        const double own = chain.body[i].velocity(V);
        const auto here = linearise(friction, own);
        // a curve may be flat around the joint's own velocity and bend far from it
        for (const double times : {1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.37, 2.3, 10.0, 1e2, 1e3, 1e4, 1e5})
            if (!same(here, linearise(friction, times * own))) return true;
    }
    return false;
}

StableGains stable_gains(const Joint& joint, Theory theory)
{
    const double V = sliding_velocity(joint);
    StableGains gains;
    if (loop_kind(joint) != LoopKind::ideal) {
        auto linear = linear_joint(joint, V);
        if (theory == Theory::velocity_only) linear = velocity_only(std::move(linear));
        const auto loop = real_loop(joint, linear, V, TurnedGain::k_p);
        if (loop) return turned_gains(*loop);
        gains.known = false;
        return gains;
    }
    if (gain_moves_sliding(joint)) return scan_gains(joint, theory);
    if (theory == Theory::velocity_only) {
        const auto curve = velocity_only(linear_joint(joint, V));
        gains.crossings = rational_crossings(curve, Gain::k_p);
        gains.stable = stable_intervals(curve, gains.crossings, gains.searched_to);
        take_single_gain(gains);
        return gains;
    }
    if (is_plain_mass(joint)) {
        const auto mass = linear_mass(joint, V);
        if (mass.friction.rational()) {
            gains.crossings = crossings(mass);
            gains.stable = stable_intervals(mass, gains.crossings);
            take_single_gain(gains);
            return gains;
        }
    }
    const auto linear = linear_joint(joint, V);
    auto search = crossings(linear);
    gains.crossings = std::move(search.crossings);
    gains.searched_to = search.searched_to;
    gains.doubtful = std::move(search.doubtful);
    gains.stable = stable_intervals(linear, gains.crossings, gains.searched_to);
    // where delays go on, so may the crossings
    if (gains.searched_to == infinity) take_single_gain(gains);
    return gains;
}

}  // namespace stickslip
