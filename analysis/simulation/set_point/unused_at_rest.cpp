#include "analysis/simulation/set_point/unused_at_rest.h"

#include "analysis/friction/friction.h"
#include "analysis/joint/gains.h"
#include "analysis/simulation/set_point/set_point_load.h"
#include "analysis/simulation/set_point/sliding_loop.h"

#include <cmath>

namespace stickslip {
namespace {

/// Effort that this shakes about the static friction with, per that: more breaks it before the integral does.
constexpr double felt_shaking = 0.1;

/// Standard deviation of the command that the noise of the encoder makes, in effort.
double noise_effort(const Joint& joint, double per_signal)
{
    const auto& c = joint.control;
    const double noise = joint.sensor.position_noise, T = c.period, tau = c.velocity_estimate.tau;
    const bool differenced = is_set(T) && c.velocity_estimate.form != EstimateForm::exact;
    const auto gains = gains_of(c);
    const double by_velocity = differenced ? gains.k_v * std::sqrt(2.0) / (c.velocity_estimate.average * (T + tau)) : 0;
    return std::abs(per_signal) * noise * std::hypot(gains.k_p, by_velocity);
}

}  // namespace

std::vector<std::string> unused_at_rest(const Joint& joint)
{
    std::vector<std::string> keys;
    const auto add = [&](bool used, const char* key) {
        if (used) keys.emplace_back(key);
    };
    add(joint.sensor.position_noise > 0, "sensor.position_noise");
    add(joint.load.disturbance.amplitude != 0, "load.disturbance.amplitude");
    add(joint.normal.moves(), "normal");
    add(joint.friction.drift.change != 0, "friction.drift.change");
    add(joint.neighbour.size > 0, "neighbour");
    return keys;
}

bool matters_at_rest(const Joint& joint, double per_signal)
{
    const double held = felt_shaking * static_force(joint.friction);
    return joint.normal.moves() || joint.neighbour.size > 0 || std::abs(joint.load.disturbance.amplitude) > held ||
           noise_effort(joint, per_signal) > held;
}

bool is_simulated(const Joint& joint)
{
    return acts_late(joint) || load_bends(joint) || joint.sensor.encoder_quantum > 0 ||
           joint.actuator.sag_effort < infinity || joint.actuator.supply_resistance > 0;
}

}  // namespace stickslip
