// What the controller of a real loop makes of small motions, apart from the one gain that is turned. Internal to
// analysis/stability.
#pragma once
#include <optional>

#include "analysis/stability/real_loop.h"

namespace stickslip {

/// The mechanism without its loop. Force control keeps the finger, which is no part of the controller.
LinearJoint opened(const Joint& joint, LinearJoint linear);

struct SplitGains {
    LoopGains base, turned;
    double gain;
    double per_gain = 1, at_none = 0;  ///< as in RealLoop
};

/// Gains are searched from zero on in the direction `towards`: 1, or −1 where the motor is wired the other way round
/// and its gains are negative for it.
std::optional<SplitGains> split(const Joint& joint, double velocity, TurnedGain turned, double towards);

/// k_p = K_v K_pos + K_i of a cascade, in place of the K_pos that was turned, and gains below zero as what they are.
void report(const RealLoop& loop, StableGains& gains);

}  // namespace stickslip
