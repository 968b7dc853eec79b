#include "analysis/stability/effort_limits.h"

#include "analysis/joint/steady_output.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/warming.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// At the winding, nothing of the supply counted.
double winding_voltage(const Actuator& a, double effort, double velocity)
{
    return effort * a.resistance / (a.effort_gain * a.k_t) + a.k_e * velocity;
}

}  // namespace

double command_for(const Actuator& a, double effort, double velocity)
{
    if (a.kind == ActuatorKind::effort) {
        const double left = 1 - std::abs(effort) / a.sag_effort;  // nothing sags where sag_effort is infinite
        return left > 0 ? effort / left / a.effort_gain : missing;
    }
    const bool duty = a.signal == DriveSignal::duty;
    const double supply = a.supply_voltage, volts = winding_voltage(a, effort, velocity);
    if (!is_set(supply)) return volts;
    // effort (R + |D| R_b) = k_t (D U − k_e v)
    const double left = supply - std::abs(effort / (a.effort_gain * a.k_t)) * a.supply_resistance;
    return left > 0 ? volts / left * (duty ? 1 : supply) : missing;
}

bool integral_at_limit(const Joint& joint)
{
    const auto& c = joint.control;
    if (c.integral_limit == infinity || c.kind == ControlKind::force) return false;
    const double velocity = sliding_velocity(joint);
    const double rate = joint.sensor.position_scale * velocity;
    return steady_output(c, command_for(joint.actuator, steady_effort(joint, velocity), velocity), rate, rate).at_limit;
}

Joint without_integral(const Joint& joint)
{
    Joint left = joint;
    left.control.k_i = 0;
    left.control.velocity_integral_gain = left.control.velocity_reset_time = not_set;
    return left;
}

Joint without_stopped_integral(const Joint& joint)
{
    return integral_at_limit(joint) ? without_integral(joint) : joint;
}

Joint acting_joint(const Joint& joint)
{
    return with_gains(without_stopped_integral(joint));
}

namespace {

/// A limit that only just leaves the effort leaves nothing to act on a disturbance with.
std::optional<LowLimit> of_an_effort(const Joint& joint, double effort)
{
    const auto& a = joint.actuator;
    if (!(effort < a.sag_effort)) return LowLimit{"actuator.sag_effort", Quantity::effort, a.sag_effort, effort};
    if (effort >= a.limit) return LowLimit{"actuator.limit", Quantity::effort, a.limit, effort};
    const double command = std::abs(command_for(a, effort, 0)), limit = joint.control.effort_limit;
    if (!(command < limit)) return LowLimit{"control.effort_limit", Quantity::effort, limit, command};
    return std::nullopt;
}

/// The controller's output is a voltage or, with `signal = "duty"`, a share of the supply.
std::optional<LowLimit> of_a_motor(const Joint& joint, double effort, double velocity)
{
    const auto& a = joint.actuator;
    if (std::abs(effort) >= a.limit) return LowLimit{"actuator.limit", Quantity::effort, a.limit, std::abs(effort)};
    const double volts = std::abs(winding_voltage(a, effort, velocity));
    const bool duty = a.signal == DriveSignal::duty;
    const LowLimit supply{"actuator.supply_voltage", Quantity::voltage, a.supply_voltage, volts};
    if (is_set(a.supply_voltage) && volts >= a.supply_voltage) return supply;
    if (!(actuation(joint, velocity, effort).gain * a.effort_gain > 0))
        return supply;  // it sags before the effort is reached
    const double command = std::abs(command_for(a, effort, velocity));
    if (command >= joint.control.effort_limit)
        return LowLimit{"control.effort_limit", duty ? Quantity::number : Quantity::voltage, joint.control.effort_limit,
                        command};
    return std::nullopt;
}

/// Without a velocity there is no effort of steady sliding, and no limit is to blame.
std::optional<LowLimit> below(const Joint& joint, double effort, double velocity)
{
    if (!is_set(effort) || !is_set(velocity)) return std::nullopt;
    return joint.actuator.kind == ActuatorKind::effort ? of_an_effort(joint, std::abs(effort))
                                                       : of_a_motor(joint, effort, velocity);
}

/// What friction takes at rest, or in the creep of a law that knows no rest, beyond that of sliding, in joint
/// coordinates: at most, as bodies may break away one after the other.
double beyond_sliding(const Joint& joint, double velocity)
{
    constexpr double creep = 0.01;  // of the velocity
    const Chain chain = chain_of(joint);
    double more = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& b = chain.body[i];
        const double sliding = std::abs(steady_force(*b.friction, b.velocity(velocity)));
        const double creeping = std::abs(steady_force(*b.friction, b.velocity(creep * velocity)));
        more += b.ratio * std::max(0.0, std::max(static_force(*b.friction), creeping) - sliding);
    }
    return joint.mechanism.model == Model::single_mass ? more / (1 - joint.friction.load_coefficient) : more;
}

}  // namespace

std::optional<LowLimit> low_limit(const Joint& joint, double velocity)
{
    if (joint.control.kind == ControlKind::force) return std::nullopt;
    const double pull = std::abs(joint.load.gravity_amplitude), warmed = warming(joint);
    std::optional<LowLimit> low;
    const auto take = [&](double cold) {
        for (const double effort : {cold, cold + std::copysign(warmed, velocity)}) {
            const auto there = below(joint, effort, velocity);
            if (there && !(low && low->needed >= there->needed)) low = there;
        }
    };
    take(steady_effort(joint, velocity));
    if (pull > 0) {
        Joint pulled = joint;
        for (const double side : {-pull, pull}) {
            pulled.load.constant = joint.load.constant + side;
            take(steady_effort(pulled, velocity));
        }
    }
    if (!low) return low;
    low->velocity = velocity, low->friction = steady_sliding(joint).friction;
    return low;
}

std::optional<LowLimit> low_limit_at_rest(const Joint& joint, double velocity)
{
    if (joint.control.kind == ControlKind::force) return std::nullopt;
    const double more = std::copysign(beyond_sliding(joint, velocity), velocity);
    return below(joint, steady_effort(joint, velocity) + more, 0);
}

}  // namespace stickslip
