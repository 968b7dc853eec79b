#include "analysis/simulation/set_point/unused_at_rest.h"

namespace stickslip {

std::vector<std::string> unused_at_rest(const Joint& joint)
{
    std::vector<std::string> keys;
    const auto add = [&](bool used, const char* key) {
        if (used) keys.emplace_back(key);
    };
    add(is_set(joint.control.period), "control.period");
    add(joint.control.delay > 0, "control.delay");
    add(joint.sensor.delay > 0, "sensor.delay");
    add(joint.control.velocity_estimate.tau > 0, "control.velocity_estimate.tau");
    add(joint.control.velocity_estimate.average > 1, "control.velocity_estimate.average");
    add(joint.actuator.lag > 0, "actuator.lag");
    add(joint.actuator.sag_effort < infinity, "actuator.sag_effort");
    add(joint.actuator.supply_resistance > 0, "actuator.supply_resistance");
    add(joint.sensor.encoder_quantum > 0, "sensor.encoder_quantum");
    add(joint.sensor.position_noise > 0, "sensor.position_noise");
    add(joint.load.gravity_amplitude != 0, "load.gravity_amplitude");
    add(joint.load.cogging.acts(), "load.cogging.amplitude");
    add(joint.load.disturbance.amplitude != 0, "load.disturbance.amplitude");
    add(joint.normal.moves(), "normal");
    add(joint.friction.drift.change != 0, "friction.drift.change");
    add(joint.control.contact_stiffness != 0, "control.contact_stiffness");
    add(joint.neighbour.size > 0, "neighbour");
    return keys;
}

}  // namespace stickslip
