#include "tests/blind/generate/geared.h"

#include <cmath>

namespace blind {
namespace {

/// An effort source whose command is the effort itself: the command then is the motor's, too.
bool commands_effort(const Drive& d)
{
    return d.kind == Drive::Kind::effort && d.gain == 1;
}

}  // namespace

double motor_factor(const std::string& path, const Machine& machine)
{
    const double N = machine.reduction;
    const auto ends = [&](const char* leaf) { return path.ends_with(leaf); };
    if (path == "joint.motor_inertia") return 1 / (N * N);
    if (path.starts_with("friction.motor.")) {
        if (ends(".viscous") || ends(".c1") || ends("bristle.damping") || ends("bristle.stiffness")) return 1 / (N * N);
        if (ends(".c3") || ends(".V_star") || ends(".L")) return N;
        if (ends(".c4") || ends(".lag") || ends("time_constant") || ends("load_coefficient") || ends(".phase"))
            return 1;
        return 1 / N;  // levels, and periods per angle of the motor
    }
    if (path == "control.dead_zone") return N;
    if (path == "control.feed_forward.coulomb") return commands_effort(machine.drive) ? 1 / N : 1;
    if (path == "control.k_p" || path == "control.k_v" || path == "control.k_i" ||
        path == "control.velocity_integral_gain")
        return commands_effort(machine.drive) ? 1 / (N * N) : 1 / N;
    if (path == "actuator.effort_gain" && machine.drive.kind == Drive::Kind::effort)
        return commands_effort(machine.drive) ? 1 : 1 / N;
    if (path == "actuator.limit" || path == "actuator.sag_effort") return 1 / N;
    if (path == "sensor.encoder_quantum" || path == "sensor.position_offset") return N;
    if (path == "signal.position") return N;
    if (path == "signal.effort_command" || path == "signal.effort_measured") return 1 / N;
    return 1;
}

Machine at_motor(const Machine& machine)
{
    const double N = machine.reduction;
    if (N == 1) return machine;
    Machine m = machine;
    auto& body = m.mechanism;
    body.inertia[0] /= N * N;
    auto& f = body.friction[0];
    for (double* level : {&f.coulomb, &f.static_rise}) *level /= N;
    f.viscous /= N * N;
    f.stribeck_velocity *= N;
    const double gains = motor_factor("control.k_p", machine);
    auto& c = m.controller;
    for (double* gain : {&c.k_p, &c.k_v, &c.k_i, &c.velocity_gain, &c.velocity_integral}) *gain *= gains;
    c.dead_zone *= N, c.coulomb_speed *= N;
    if (commands_effort(m.drive)) c.limit /= N, c.coulomb /= N;
    if (m.drive.kind == Drive::Kind::effort && !commands_effort(m.drive)) m.drive.gain /= N;
    m.drive.torque_constant /= N, m.drive.back_emf /= N;
    m.sensors.quantum *= N, m.sensors.position_noise *= N, m.sensors.effort_noise /= N;
    return m;
}

Record at_motor(Record r, const Machine& machine)
{
    const double N = machine.reduction;
    if (N == 1) return r;
    const auto times = [](std::vector<double>& values, double factor) {
        for (double& x : values) x *= factor;
    };
    for (auto* motion : {&r.reference_position, &r.reference_velocity, &r.position, &r.velocity}) times(*motion, N);
    times(r.effort, 1 / N);
    if (commands_effort(machine.drive)) times(r.command, 1 / N);
    return r;
}

}  // namespace blind
