// Effects of the actuator, the controller and the sensor.
#include "tests/blind/generate/effects_parts.h"

#include <algorithm>
#include <stdexcept>

namespace blind {
namespace {

const std::vector<std::string> effort_sources = {"revolute",    "pendulum", "prismatic",
                                                 "drive-volts", "two-mass", "stribeck"};

/// An effect that scales one number by 1 ± size.
Edit scaled(const char* path, double smallest, double largest, double nominal, double& (*slot)(Machine&), Draw& draw)
{
    Edit e{.smallest = smallest, .largest = largest};
    const double side = draw.sign();
    e.apply = [=](Machine& m, double size) -> Changed { return {changed(path, slot(m), nominal * (1 + side * size))}; };
    return e;
}

/// An effect that adds its size to one time.
Edit later(const char* path, double smallest, double largest, double nominal, double& (*slot)(Machine&))
{
    Edit e{.smallest = smallest, .largest = largest};
    e.apply = [=](Machine& m, double size) -> Changed { return {changed(path, slot(m), nominal + size)}; };
    return e;
}

/// Effort at rest per unit of the drive's signal.
double effort_per_signal(const Drive& d)
{
    if (d.kind == Drive::Kind::effort) return d.gain;
    return d.gain * d.torque_constant / d.resistance * (d.kind == Drive::Kind::dc_duty ? d.supply : 1);
}

Edit effort_gain(const Nominal& n, double, Draw& draw)
{
    if (n.machine.drive.kind != Drive::Kind::effort)
        throw std::runtime_error("a motor's current is logged through the same gain: it shows as the inertia does");
    return scaled(
        "actuator.effort_gain", 0.01, 0.4, n.machine.drive.gain, [](Machine& m) -> double& { return m.drive.gain; },
        draw);
}

Edit saturation(const Nominal& n, double peak_command, Draw&)
{
    Edit e{.smallest = 0.05, .largest = 0.8};
    e.apply = [peak = peak_command * effort_per_signal(n.machine.drive)](Machine& m, double size) -> Changed {
        return {changed("actuator.limit", m.drive.limit, peak * (1 - size))};
    };
    return e;
}

Edit supply_sag(const Nominal& n, double peak_command, Draw&)
{
    if (n.machine.drive.kind == Drive::Kind::effort) {
        Edit e{.variant = "of-an-effort-source", .smallest = 0.03, .largest = 0.6};
        e.apply = [peak = peak_command * n.machine.drive.gain](Machine& m, double size) -> Changed {
            return {changed("actuator.sag_effort", m.drive.sag_effort, peak / size)};
        };
        return e;
    }
    Edit e{.variant = "of-a-motor", .smallest = 0.02, .largest = 0.8};
    e.apply = [winding = n.machine.drive.resistance](Machine& m, double size) -> Changed {
        return {changed("actuator.supply_resistance", m.drive.supply_resistance, size * winding)};
    };
    return e;
}

Edit actuator_lag(const Nominal&, double, Draw&)
{
    return later("actuator.lag", 3e-4, 3e-2, 0, [](Machine& m) -> double& { return m.drive.lag; });
}
Edit delay(const Nominal&, double, Draw&)
{
    return later("control.delay", 3e-4, 2e-2, 0, [](Machine& m) -> double& { return m.drive.dead_time; });
}
Edit velocity_filter(const Nominal& n, double, Draw&)
{
    return later("control.velocity_estimate.tau", 5e-4, 2.5e-2, n.machine.controller.filter,
                 [](Machine& m) -> double& { return m.controller.filter; });
}
Edit gain_k_p(const Nominal& n, double, Draw& draw)
{
    return scaled(
        "control.k_p", 5e-3, 0.5, n.machine.controller.k_p, [](Machine& m) -> double& { return m.controller.k_p; },
        draw);
}
Edit gain_k_v(const Nominal& n, double, Draw& draw)
{
    return scaled(
        "control.k_v", 1e-2, 0.7, n.machine.controller.k_v, [](Machine& m) -> double& { return m.controller.k_v; },
        draw);
}

Edit gain_k_i(const Nominal& n, double, Draw& draw)
{
    const auto& c = n.machine.controller;
    if (c.cascade)
        return scaled(
            "control.velocity_integral_gain", 1e-2, 0.8, c.velocity_integral,
            [](Machine& m) -> double& { return m.controller.velocity_integral; }, draw);
    return scaled(
        "control.k_i", 1e-2, 0.8, c.k_i, [](Machine& m) -> double& { return m.controller.k_i; }, draw);
}
/// A Coulomb friction that the controller compensates without the document's saying so.
Edit feed_forward(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 1};
    const double level = n.machine.mechanism.friction[0].coulomb / effort_per_signal(n.machine.drive);
    const double speed = n.bandwidth * n.travel * draw.log_uniform(0.01, 0.1);
    e.apply = [=](Machine& m, double size) -> Changed {
        m.controller.coulomb_speed = speed;
        return {changed("control.feed_forward.coulomb", m.controller.coulomb, size * level)};
    };
    return e;
}
Edit dead_zone(const Nominal& n, double, Draw&)
{
    Edit e{.smallest = 1e-4, .largest = 0.05};
    e.apply = [travel = n.travel](Machine& m, double size) -> Changed {
        return {changed("control.dead_zone", m.controller.dead_zone, size * travel)};
    };
    return e;
}

Edit quantisation(const Nominal& n, double, Draw&)
{
    const auto& s = n.machine.sensors;
    Edit e{.smallest = std::max(3 * s.position_noise, 2 * s.quantum) / n.travel, .largest = 0.02};
    e.apply = [travel = n.travel](Machine& m, double size) -> Changed {
        return {changed("sensor.encoder_quantum", m.sensors.quantum, size * travel)};
    };
    return e;
}

Edit sensor_offset(const Nominal& n, double, Draw& draw)
{
    if (draw.chance(0.2)) {
        Edit e = scaled(
            "sensor.position_scale", 0.01, 0.2, n.machine.sensors.scale,
            [](Machine& m) -> double& { return m.sensors.scale; }, draw);
        e.variant = "scale";
        return e;
    }
    // Under gravity alone, an offset of the reading and a tilt of the base make the same motion.
    Edit e{.variant = "offset", .smallest = 0.005, .largest = 0.5, .equivalent = {"gravity"}};
    const double side = draw.sign();
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed("sensor.position_offset", m.sensors.offset, side * size)};
    };
    return e;
}

}  // namespace

std::vector<EffectEntry> loop_effects()
{
    return {
        {"effort-gain", effort_sources, effort_gain},
        {"saturation", effort_sources, saturation},
        {"supply-sag", {"dc-duty", "dc-duty", "revolute", "prismatic", "drive-volts"}, supply_sag},
        {"actuator-lag", joint_families(), actuator_lag},
        {"delay", joint_families(), delay},
        {"velocity-filter", joint_families(), velocity_filter},
        {"gain-k_p", joint_families(), gain_k_p},
        {"gain-k_v", joint_families(), gain_k_v},
        {"gain-k_i", joint_families(), gain_k_i},
        {"feed-forward", joint_families(), feed_forward},
        {"dead-zone", joint_families(), dead_zone},
        {"quantisation", joint_families(), quantisation},
        {"sensor-offset", {"pendulum", "dc-duty"}, sensor_offset},
    };
}

}  // namespace blind
