// Which position gains are stable: k_p as a user turns it, with all that follows from it.
#pragma once
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// The stable set in k_p and every gain at which a pair of roots crosses the imaginary axis.
struct StableGains {
    std::vector<Crossing> crossings;  ///< of the imaginary axis, over k_p
    std::vector<Interval> stable;     ///< of k_p, rising
    std::vector<Interval> doubtful;   ///< bands of ω in which a touch of the axis could not be excluded
    double searched_from = 0;         ///< crossings are complete from here
    double searched_to = infinity;    ///< up to here
    bool known = true;                ///< false: the joint's own loop has no such gain to turn alone
    double k_cr = missing;            ///< the single critical gain: all above are stable, none below [N/m | N·m/rad]
    double omega = missing;           ///< frequency of the oscillation there [rad/s]
};

/// Fills in k_cr and omega where one crossing divides the gains into none and all.
void take_single_gain(StableGains& gains);

/// Whether k_p moves the joint to another steady sliding, where friction answers differently: a force that ramps at a
/// given rate slides at rate/(k_p + k_c), and behind the springs of a ramp the motor runs ahead of the link
/// (Body::speed).
bool gain_moves_sliding(const Joint& joint);

/// For a joint that slides steadily. Where k_p moves the sliding, by scan_gains.
StableGains stable_gains(const Joint& joint, Theory theory = Theory::state_variable);

}  // namespace stickslip
