#include "analysis/loop/loop_use.h"

#include "analysis/joint/loop_side.h"
#include "analysis/joint/steady_output.h"
#include "analysis/loop/felt.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Whether anything of the motion comes back to the motor.
bool feeds_back(const Joint& joint)
{
    return joint.control.kind == ControlKind::position || joint.control.force_gain != 0;
}

/// A force loop feeds back the force, whatever the encoder reads per displacement.
bool reads_scaled(const Joint& joint)
{
    return joint.sensor.position_scale != 1 && joint.control.kind == ControlKind::position;
}

}  // namespace

LoopKind loop_kind(const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    if (!feeds_back(joint)) return LoopKind::ideal;
    if (is_set(c.period)) return LoopKind::sampled;
    const bool delayed = joint.dead_time() > 0 || a.lag > 0 || c.velocity_estimate.tau > 0;
    const bool pushes = is_set(c.V0) && push_slope(c.feed_forward, c.V0) != 0;
    const bool other = pushes || gains_of(c).k_i != 0 || a.effort_gain != 1 || reads_scaled(joint) ||
                       a.sag_effort < infinity || a.kind == ActuatorKind::dc_motor;
    return delayed || other ? LoopKind::continuous : LoopKind::ideal;
}

namespace {

/// Collects what a loop uses and what it cannot.
struct Collector {
    LoopUse use;
    bool acts;  ///< the loop feeds anything back

    void take(bool present, const char* key)
    {
        if (!present) return;
        if (acts)
            use.used.emplace_back(key);
        else
            leave(true, key, WhyNot::no_feedback, false);
    }
    void leave(bool present, std::string_view key, WhyNot why, bool matters)
    {
        if (present) use.not_used.push_back({std::string(key), why, matters});
    }
};

void take_controller(Collector& c, const Joint& joint)
{
    const auto& control = joint.control;
    const auto& estimate = control.velocity_estimate;
    const bool sampled = is_set(control.period), cascade = control.structure == Structure::cascade;
    const auto& f = control.feed_forward;
    const bool estimates = (gains_of(control).k_v != 0 || f.by_velocity()) && control.kind == ControlKind::position;
    c.take(cascade, "control.position_gain");
    c.take(cascade, "control.velocity_gain");
    c.take(cascade && is_set(control.velocity_integral_gain), "control.velocity_integral_gain");
    c.take(cascade && is_set(control.velocity_reset_time), "control.velocity_reset_time");
    c.take(!cascade && control.k_i != 0, "control.k_i");
    c.take(sampled, "control.period");
    c.take(control.delay > 0, "control.delay");
    c.take(joint.sensor.delay > 0, "sensor.delay");
    if (estimates) {
        c.take(sampled && estimate.form != EstimateForm::unstated, "control.velocity_estimate.form");
        // a sampled loop that is told its velocity estimates none
        const bool told = sampled && estimate.form == EstimateForm::exact;
        c.take(estimate.tau > 0 && !told, "control.velocity_estimate.tau");
        c.leave(estimate.tau > 0 && told, "control.velocity_estimate.tau", WhyNot::told_velocity, true);
        c.take(sampled && estimate.average > 1 && !told, "control.velocity_estimate.average");
        c.leave(estimate.average > 1 && told, "control.velocity_estimate.average", WhyNot::told_velocity, true);
        c.leave(!sampled && estimate.average > 1, "control.velocity_estimate.average", WhyNot::needs_period, true);
    } else {
        c.leave(estimate.tau > 0, "control.velocity_estimate.tau", WhyNot::no_feedback, false);
        c.leave(estimate.average > 1, "control.velocity_estimate.average", WhyNot::no_feedback, false);
    }
    const bool by_force = control.kind == ControlKind::force;
    c.leave(by_force && is_set(control.force_rate) && is_set(control.V0), "control.V0", WhyNot::overruled, false);
    c.leave(!by_force && is_set(control.force_rate), "control.force_rate", WhyNot::other_kind, false);
    c.leave(!by_force && control.force_gain != 0, "control.force_gain", WhyNot::other_kind, false);
    c.leave(!control.reference_velocity, "control.reference_velocity", WhyNot::reference_only, false);
    c.leave(f.velocity != 1 || f.acceleration != 0 || (f.coulomb != 0 && !f.fed_back()), "control.feed_forward",
            WhyNot::reference_only, false);
    c.take(f.by_velocity(), "control.feed_forward.coulomb_from");
    c.leave(f.by_error(), "control.feed_forward.coulomb_from", WhyNot::fed_back, f.by_error() && push_is_felt(joint));
    c.leave(control.dither.amplitude > 0, "control.dither", WhyNot::time, dither_is_felt(joint));
    c.leave(f.gravity, "control.feed_forward.gravity", WhyNot::reference_only, false);
    c.leave(control.effort_limit < infinity, "control.effort_limit", WhyNot::small_signal, false);
    c.leave(control.integral_limit < infinity, "control.integral_limit", WhyNot::small_signal, false);
    c.leave(control.integral_band < infinity, "control.integral_band", WhyNot::small_signal, false);
    c.leave(control.anti_windup != AntiWindup::none, "control.anti_windup", WhyNot::small_signal, false);
    c.leave(control.dead_zone > 0, "control.dead_zone", WhyNot::small_signal, true);
}

void take_drive(Collector& c, const Joint& joint)
{
    const auto& a = joint.actuator;
    const bool motor = a.kind == ActuatorKind::dc_motor;
    c.take(a.effort_gain != 1, "actuator.effort_gain");
    c.take(a.lag > 0, "actuator.lag");
    for (const char* key : {"actuator.k_t", "actuator.k_e", "actuator.resistance"}) c.take(motor, key);
    c.take(motor && is_set(a.supply_voltage), "actuator.supply_voltage");
    c.take(motor && a.supply_resistance > 0, "actuator.supply_resistance");
    c.take(!motor && a.sag_effort < infinity, "actuator.sag_effort");
    c.leave(a.limit < infinity, "actuator.limit", WhyNot::small_signal, false);
    const auto& s = joint.sensor;
    c.take(reads_scaled(joint), "sensor.position_scale");
    c.leave(s.position_scale != 1 && !reads_scaled(joint), "sensor.position_scale", WhyNot::no_feedback, false);
    c.leave(s.encoder_quantum > 0, "sensor.encoder_quantum", WhyNot::rounding, false);
    c.leave(s.position_noise > 0, "sensor.position_noise", WhyNot::rounding, false);
    c.leave(s.position_offset != 0, "sensor.position_offset", WhyNot::reference_only, false);
}

/// Of one body, which turns `ratio` times as far as the joint.
void leave_friction(Collector& c, const Joint& joint, const Friction& f, const std::string& table, double ratio)
{
    c.leave(f.ripple.acts(), table + ".ripple", WhyNot::place, noticed(joint, ratio * ratio * f.ripple.steepest()));
    c.leave(f.drift.change != 0, table + ".drift", WhyNot::time, false);
}

void leave_surroundings(Collector& c, const Joint& joint)
{
    const auto& l = joint.load;
    const auto& m = joint.mechanism;
    c.leave(l.gravity_amplitude != 0, "load.gravity_amplitude", WhyNot::place, noticed(joint, l.gravity_amplitude));
    c.leave(l.cogging.acts(), "load.cogging", WhyNot::place, noticed(joint, l.cogging.steepest()));
    c.leave(l.disturbance.amplitude != 0, "load.disturbance", WhyNot::time,
            l.disturbance.amplitude != 0 && disturbance_is_felt(joint));
    const bool chain = m.model == Model::three_mass || m.model == Model::lever;
    if (m.model == Model::single_mass) {
        leave_friction(c, joint, joint.friction, "friction", 1);
        c.leave(joint.friction.gear.acts(), "friction.gear", WhyNot::load_direction, true);
    } else {
        const double behind = chain ? m.transmission_link.ratio : 1;
        const double before = chain ? m.motor_transmission.ratio * behind : m.transmission.ratio;
        leave_friction(c, joint, joint.frictions.motor, "friction.motor", before);
        if (chain) leave_friction(c, joint, joint.frictions.transmission, "friction.transmission", behind);
        leave_friction(c, joint, joint.frictions.link, "friction.link", 1);
    }
    c.leave(m.model == Model::two_mass && m.transmission.backlash > 0, "joint.transmission.backlash", WhyNot::backlash,
            true);
    c.leave(chain && m.motor_transmission.backlash > 0, "joint.motor_transmission.backlash", WhyNot::backlash, true);
    c.leave(chain && m.transmission_link.backlash > 0, "joint.transmission_link.backlash", WhyNot::backlash, true);
}

}  // namespace

GearSide gear_side(const Joint& joint)
{
    const double N = gear_ratio(joint), reading = reading_per_joint(joint);
    const bool dc_motor = joint.actuator.kind == ActuatorKind::dc_motor;
    return {N, dc_motor ? reading : reading * N, dc_motor, reading == 1};
}

LoopUse loop_use(const Joint& joint)
{
    Collector c{{}, feeds_back(joint)};
    c.use.kind = loop_kind(joint);
    c.use.gear = gear_side(joint);
    take_controller(c, joint);
    take_drive(c, joint);
    leave_surroundings(c, joint);
    return std::move(c.use);
}

Joint with_ideal_loop(Joint joint)
{
    joint = with_gains(std::move(joint));
    auto& c = joint.control;
    c.k_i = 0;
    c.period = not_set;
    c.delay = 0;
    c.velocity_estimate = {};
    c.effort_limit = infinity;
    c.dead_zone = 0;
    c.feed_forward = {};
    c.dither = {};
    // what stays are constant factors: without them gains in V/m would be taken for N/m
    joint.actuator.lag = 0;
    joint.actuator.limit = infinity;
    const double scale = joint.sensor.position_scale;
    joint.sensor = {};
    joint.sensor.position_scale = scale;
    return joint;
}

LoopUse left_out_by_ideal(const Joint& joint)
{
    auto use = loop_use(joint);
    auto kept = loop_use(with_ideal_loop(joint)).used;
    for (const char* made_k_p_and_k_v : {"control.position_gain", "control.velocity_gain"})
        kept.emplace_back(made_k_p_and_k_v);
    std::erase_if(use.used, [&](const auto& key) { return std::find(kept.begin(), kept.end(), key) != kept.end(); });
    return use;
}

}  // namespace stickslip
