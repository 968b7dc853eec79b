// The record simulator against CVODE, effect by effect and form by form: both follow the same reference with the same
// sampled controller; CVODE integrates the mechanism between events at a tolerance of 1e-9. Random noise is the only
// part of the catalogue's world that is left out: two simulations of it agree in distribution only.
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "tests/analysis/diagnosis/continuous_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr int ticks = 700;
constexpr double period = 1e-3;

double reference(double t)
{
    return 0.02 * (1 - std::cos(9 * t)) + 0.004 * std::sin(31 * t);
}
double reference_rate(double t)
{
    return 0.18 * std::sin(9 * t) + 0.124 * std::cos(31 * t);
}

Joint pushed_mass()
{
    Joint j;
    j.mechanism.inertia = 1.2;
    CoulombViscous law;
    law.coulomb = 2;
    law.viscous = 1.5;
    j.friction.law = law;
    j.load.gravity_amplitude = 8;
    j.control.k_p = 1200;
    j.control.k_v = 45;
    j.control.period = period;
    j.control.velocity_estimate.tau = 0.003;
    return j;
}

Joint motor()
{
    Joint j = pushed_mass();
    j.actuator.kind = ActuatorKind::dc_motor;
    j.actuator.signal = DriveSignal::duty;
    j.actuator.k_t = j.actuator.k_e = 2;
    j.actuator.resistance = 1;
    j.actuator.supply_voltage = 24;
    j.control.k_p = 25;
    j.control.k_v = 1;
    j.control.effort_limit = 1;
    return j;
}

Joint two_masses()
{
    Joint j = pushed_mass();
    j.mechanism.model = Model::two_mass;
    j.mechanism.motor_inertia = 0.5;
    j.mechanism.link_inertia = 0.7;
    j.mechanism.transmission.stiffness = 2e4;
    j.mechanism.transmission.damping = 20;
    j.frictions.motor = j.frictions.link = j.friction;
    return j;
}

/// Sizes that this reference gives: some newtons, a quarter of a metre a second, four centimetres.
Scales scales()
{
    Scales s;
    s.effort = 5;
    s.peak_effort = 12;
    s.velocity = 0.25;
    s.position = 0.045;
    s.inertia = 1.2;
    s.tick = period;
    s.duration = 0.7;
    s.coulomb = 2;
    s.command = 12;
    s.supply = 24;
    return s;
}

std::vector<double> simulated(const Joint& joint)
{
    Record r;
    for (int k = 0; k < ticks; ++k) {
        r.time.push_back(k * period);
        r.position.push_back(0);
        r.reference_position.push_back(reference(k * period));
        r.reference_velocity.push_back(reference_rate(k * period));
    }
    return simulate_closed_loop(flatten(joint), on_clock(r, joint), 0).position;
}

double rms(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Every form of the catalogue that this joint can have, at its usual size.
void compare_all(const Joint& nominal, const std::function<bool(const EffectForm&)>& chosen)
{
    const auto plain = test::ContinuousMachine(nominal).follow(reference, reference_rate, ticks);
    const double span = 0.045, alone = rms(simulated(nominal), plain);
    INFO("nominal: " << alone);
    CHECK(alone < 1e-4 * span);
    for (const auto& effect : effects())
        for (const auto& form : effect.forms) {
            const Candidate c{{&effect}, {&form}, 1};
            if (!c.applies(nominal) || !chosen(form)) continue;
            std::vector<double> usual;
            for (std::size_t i = 0; i < c.parameter_count(); ++i) usual.push_back(c.parameter(i).prior);
            // factors of one are no change
            if (effect.name == "inertia" || effect.name == "effort-gain") usual[0] = 1.2;
            if (effect.name == "velocity-filter") usual[0] *= 3;  // the usual one is the nominal one
            // behind a spring as soft as usual this loop would be unstable, which magnifies every error
            for (std::size_t i = 0; i < usual.size(); ++i)
                if (form.name.ends_with("encoder-on-link") && c.parameter(i).name == "stiffness") usual[i] *= 4;
            const Joint joint = edited(nominal, c, in_si(c, to_fit(c, usual), scales()), 0);
            const auto exact = test::ContinuousMachine(joint).follow(reference, reference_rate, ticks);
            const double error = rms(simulated(joint), exact), change = rms(exact, plain);
            INFO(effect.name << " " << form.name << ": error " << error << " m, the effect changes the motion by "
                             << change);
            CHECK(change > 20 * alone);
            CHECK(error < 0.02 * change + alone);
            CHECK(error < 2e-3 * span);
        }
}

}  // namespace

TEST_CASE("the record simulator follows CVODE with every effect of a single mass", "[gap][cvode][slow]")
{
    compare_all(pushed_mass(), [](const EffectForm&) { return true; });
}

TEST_CASE("the record simulator follows CVODE with a motor whose supply sags", "[gap][cvode]")
{
    compare_all(motor(), [](const EffectForm& f) { return f.name == "motor"; });
}

TEST_CASE("the record simulator follows CVODE with two masses, soft or with backlash", "[gap][cvode]")
{
    compare_all(two_masses(), [](const EffectForm& f) { return f.name.starts_with("two-mass"); });
}
