#include "analysis/diagnosis/plant/plant.h"

#include "analysis/results/cannot_answer.h"
#include "analysis/results/not_fitted.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::gap {
namespace {

void take(const CoulombViscous& law, FlatFriction& r)
{
    r.coulomb = law.coulomb;
    r.viscous = law.viscous;
}

void take(const Stribeck& law, FlatFriction& r)
{
    r.coulomb = law.c0;
    r.viscous = law.c1;
    r.stribeck = law.c2;
    r.stribeck_velocity = law.c3;
    r.exponent = law.c4;
}

void take(const RateAndState& law, FlatFriction& r)
{
    if (law.B.size > 1) throw NotFitted(NotFitted::Why::several_states, law.info.name);
    r.coulomb = law.f0;
    r.A = law.A;
    r.V_star = law.V_star;
    if (law.B.size == 1) {
        r.B = law.B[0];
        r.L = law.L[0];
    }
}

void take(const MaxwellSlip& law, FlatFriction&)
{
    NotFitted refused(NotFitted::Why::elements, law.info.name);
    for (const auto& e : law.elements) refused.level += e.yield, refused.stiffness += e.stiffness;
    refused.viscous = law.viscous;
    throw refused;
}

void take(const TimeLag& law, FlatFriction&)
{
    NotFitted refused(NotFitted::Why::pure_delay, law.info.name);
    refused.lag = law.lag;
    throw refused;
}

template <class Law>
void take(const Law& law, FlatFriction&)
{
    throw NotFitted(NotFitted::Why::other_law, law.info.name);
}

FlatFriction flatten(const Friction& f)
{
    FlatFriction r;
    std::visit([&](const auto& law) { take(law, r); }, f.law);
    r.asymmetric_coulomb = f.asymmetry.coulomb;
    r.asymmetric_viscous = f.asymmetry.viscous;
    r.load_coefficient = f.load_coefficient;
    r.gear_forward = f.gear.forward, r.gear_backward = f.gear.backward, r.gear_beyond = f.gear.beyond;
    r.ripple = f.ripple.amplitude;
    r.ripple_periods = f.ripple.periods;
    r.ripple_phase = f.ripple.phase;
    r.second_ripple = f.ripple.second_amplitude, r.second_phase = f.ripple.second_phase;
    r.drift = f.drift.change;
    r.drift_time = f.drift.time_constant;
    r.bristle_stiffness = f.bristle.stiffness;
    r.bristle_damping = f.bristle.damping;
    if (f.memory.A != 0 || f.memory.B != 0) {
        r.A = f.memory.A;
        r.B = f.memory.B;
        r.L = f.memory.L;
        r.V_star = f.memory.V_star;
        r.ageing = f.memory.form == MemoryForm::ageing;
    }
    r.per_L = 1 / r.L, r.per_V_star = 1 / r.V_star;
    r.lag = f.memory.lag, r.lag_viscous = f.memory.lag_viscous;
    for (double* force : {&r.coulomb, &r.viscous, &r.stribeck, &r.A, &r.B, &r.asymmetric_coulomb, &r.asymmetric_viscous,
                          &r.ripple, &r.second_ripple, &r.drift, &r.bristle_stiffness, &r.bristle_damping})
        *force *= f.normal_load;
    return r;
}

constexpr double shortest_step = 15e-6;  // numerical: s

/// s, in which a body that nothing but its Stribeck peak drives crosses an eighth of the peak's width; no limit where
/// that is less than the shortest step: then the friction drops at once, as it does from a static level.
double step_over_peak(const FlatFriction& r, double inertia)
{
    constexpr double share = 0.125, none = std::numeric_limits<double>::infinity();  // numerical: of a period
    if (!(r.stribeck > 0)) return none;
    const double step = share * r.stribeck_velocity * inertia / r.stribeck;
    return step < shortest_step ? none : step;
}

}  // namespace

Plant flatten(const Joint& joint)
{
    Plant p;
    const Mechanism& m = joint.mechanism;
    if (joint.control.kind == ControlKind::force) throw CannotAnswer(CannotAnswer::Why::force_loop, "");
    if (joint.control.contact_stiffness != 0) throw CannotAnswer(CannotAnswer::Why::contact_spring, "");
    switch (m.model) {
        case Model::single_mass:
            p.motor_inertia = m.inertia;
            p.motor = flatten(joint.friction);
            break;
        case Model::two_mass:
            p.two_mass = true;
            p.motor_inertia = m.motor_inertia;
            p.link_inertia = m.link_inertia;
            p.stiffness = m.transmission.stiffness;
            p.cubic_stiffness = m.transmission.cubic_stiffness;
            p.damping = m.transmission.damping;
            p.ratio = m.transmission.ratio;
            p.backlash = m.transmission.backlash;
            p.motor = flatten(joint.frictions.motor);
            p.link = flatten(joint.frictions.link);
            p.feedback_link = joint.control.feedback == Feedback::link;
            break;
        default:
            throw CannotAnswer(CannotAnswer::Why::many_bodies, "");
    }
    p.load = joint.load;
    p.actuator = joint.actuator;
    p.control = joint.control;
    p.sensor = joint.sensor;
    p.dead_time = joint.dead_time();
    return p;
}

double longest_step(const Plant& p)
{
    // s; exact under constant force, so that only laws which bend within a tick need the shorter one
    constexpr double plain_step = 0.5e-3, bent_step = 0.25e-3;  // numerical: s
    // bristles are of second order: LuGre joints of 1e3 to 1e6 N/m are within 1e-5 of their travel
    constexpr double bristle_step = 0.125e-3;  // numerical: s
    double step = p.motor.plain() && !p.dc_motor() ? plain_step : bent_step;
    if (p.motor.bristle_stiffness > 0 || p.link.bristle_stiffness > 0) step = bristle_step;
    if (p.two_mass) {
        const double reduced = 1 / apart_per_force(p.motor_inertia, p.link_inertia, p.ratio);
        // phase error of leapfrog (ωh)²/24 ≈ 0.3 %; a spring that hardens, where it is four times as steep
        const double steepest = p.cubic_stiffness > 0 ? 4 * p.stiffness : p.stiffness;
        const double period_part = 0.25 / std::sqrt(steepest / reduced);
        step = std::clamp(period_part, shortest_step, 0.125e-3);
        if (p.backlash > 0) step = std::min(step, 0.0625e-3);
        step = std::min(step, step_over_peak(p.link, p.link_inertia));
    }
    return std::min(step, step_over_peak(p.motor, p.motor_inertia)) * p.step_factor;
}

int substeps(double tick, double longest)
{
    return std::clamp(static_cast<int>(std::ceil(tick / longest - 1e-9)), 1, 400);
}

}  // namespace stickslip::gap
