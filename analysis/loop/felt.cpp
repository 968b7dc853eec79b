#include "analysis/loop/felt.h"

#include <cmath>

#include "analysis/joint/commanded_velocity.h"
#include "analysis/joint/gains.h"

namespace stickslip {
namespace {

/// Of an effect beside which another counts for nothing.
constexpr double nothing_beside = 0.01;

/// All that moves with the link, in joint coordinates.
double moved_inertia(const Mechanism& m)
{
    if (m.model == Model::single_mass) return m.inertia;
    if (m.model == Model::two_mass)
        return m.link_inertia + m.transmission.ratio * m.transmission.ratio * m.motor_inertia;
    const double behind = m.transmission_link.ratio, before = m.motor_transmission.ratio * behind;
    const double between = m.model == Model::lever ? 0 : behind * behind * m.transmission_inertia;
    return m.link_inertia + between + before * before * m.motor_inertia;
}

/// Displacement of the link per force on it by the springs of the transmission alone.
double compliance(const Mechanism& m)
{
    if (m.model == Model::single_mass) return 0;
    if (m.model == Model::two_mass) return 1 / m.transmission.stiffness;
    return 1 / m.transmission_link.stiffness +
           1 / (m.transmission_link.ratio * m.transmission_link.ratio * m.motor_transmission.stiffness);
}

}  // namespace

double effort_per_command(const Joint& joint)
{
    const auto& a = joint.actuator;
    if (a.kind == ActuatorKind::effort) return a.effort_gain;
    const bool duty = a.signal == DriveSignal::duty;
    return a.effort_gain * a.k_t / a.resistance * (duty ? a.supply_voltage : 1);
}

bool push_is_felt(const Joint& joint)
{
    const auto& f = joint.control.feed_forward;
    const auto [k_p, k_v, k_i] = gains_of(joint.control);
    const double V0 = joint.control.V0;
    const double damping = std::abs(f.coulomb) * f.direction(V0).slope;
    const double left = std::abs(f.coulomb) * f.fade(V0, V0 < 0 ? -1 : 1).value;
    return !(damping < nothing_beside * std::abs(k_v)) || !(left < nothing_beside * std::abs(k_p) * f.coulomb_width);
}

bool dither_is_felt(const Joint& joint)
{
    const auto& m = joint.mechanism;
    const auto& d = joint.control.dither;
    const double inertia = m.model == Model::single_mass ? m.inertia : m.motor_inertia;
    const double velocity = std::abs(joint.actuator.effort_gain) * d.amplitude / (inertia * d.frequency);
    return !(velocity < nothing_beside * std::abs(joint.control.V0));
}

bool disturbance_is_felt(const Joint& joint)
{
    const auto& d = joint.load.disturbance;
    const auto [k_p, k_v, k_i] = gains_of(joint.control);
    const bool position = joint.control.kind == ControlKind::position;
    const double gain = position ? effort_per_command(joint) * joint.sensor.position_scale : 1;
    const double stiffness = gain * k_p + joint.control.contact_stiffness, damping = gain * k_v;
    const double impedance =
        std::hypot(stiffness / d.frequency - moved_inertia(joint.mechanism) * d.frequency, damping);
    const double velocity = std::abs(d.amplitude) * (1 / impedance + compliance(joint.mechanism) * d.frequency);
    return !(velocity < nothing_beside * std::abs(commanded_velocity(joint)));
}

bool noticed(const Joint& joint, double slope)
{
    return std::abs(slope) > nothing_beside * std::abs(gains_of(joint.control).k_p);
}

}  // namespace stickslip
