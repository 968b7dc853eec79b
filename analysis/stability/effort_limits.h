// Which limit of controller or actuator is below what steady sliding takes, in numbers.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/quantity.h"

#include <optional>
#include <string_view>

namespace stickslip {

/// The key that is too low, in the quantity that it limits: an effort, or the voltage or duty of a motor.
struct LowLimit {
    std::string_view path;
    Quantity quantity = Quantity::effort;
    double allowed = 0, needed = 0;
    double velocity = 0, friction = 0;  ///< of the steady sliding that it takes this much for
};

/// The command for which this actuator makes this effort at a velocity, whatever its limits: an effort, or the voltage
/// or duty of a motor. NaN where its supply sags before.
double command_for(const Actuator& actuator, double effort, double velocity);

/// Whether the integral of the controller stands at its limit in steady sliding, as it would have to hold more.
bool integral_at_limit(const Joint& joint);

/// The joint with the integral of its controller off.
Joint without_integral(const Joint& joint);

/// The joint as it is about steady sliding: an integral that stands at its limit answers no small motion. The one place
/// that takes it off, for the linear theory (linear_verdict, real_loop) and for simulations (acting_joint).
Joint without_stopped_integral(const Joint& joint);

/// The joint as small motions about steady sliding at its own velocity meet it: a cascade as its sum of gains, without
/// a stopped integral.
Joint acting_joint(const Joint& joint);

/// At V; nothing where every limit leaves the effort of steady sliding, and of force loops, whose ramp knows no limit.
/// Sliding that goes on passes every position and outlasts every change: gravity counts where it pulls most, to either
/// side, and drift of friction as far as it goes.
std::optional<LowLimit> low_limit(const Joint& joint, double velocity);

/// The same of a joint that is at rest, or creeps at a hundredth of V, and is to go on at V: what has to break is its
/// static friction, or that of the creep. A joint with such a limit stays where it came to rest.
std::optional<LowLimit> low_limit_at_rest(const Joint& joint, double velocity);

}  // namespace stickslip
