// The two simulators of a joint in its loop, the exact one of `simulate --reference` and the fast one of the diagnosis,
// make one and the same record, of every law and element that the diagnosis knows.
#include "analysis/diagnosis/plant/record_form.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/records/start_velocity.h"
#include "tests/analysis/simulation/sampled/sampled_joint.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// From rest, several speeds and directions.
ReferenceMotion lively(double seconds, double tick)
{
    ReferenceMotion r;
    const auto at = [](double t) { return 0.05 * (1 - std::cos(6 * t)) * (0.6 + 0.4 * std::sin(0.9 * t)); };
    for (int k = 0; k * tick <= seconds; ++k) {
        const double t = k * tick, h = 1e-5;
        r.time.push_back(t);
        r.position.push_back(at(t));
        r.velocity.push_back((at(t + h) - at(t - h)) / (2 * h));
    }
    return r;
}

/// Largest difference of positions, m.
double difference(const Joint& joint)
{
    const auto exact = record_along(joint, lively(3, 1e-3), 0);
    REQUIRE(exact.reason == Reason::none);
    Record record;
    record.time = exact.time, record.position = exact.position;
    record.reference_position = exact.reference_position, record.reference_velocity = exact.reference_velocity;
    const Joint written = record_form(joint);
    const auto fast = simulate_closed_loop(flatten(written), on_clock(record, written), 0);
    double worst = 0;
    for (std::size_t k = 0; k < record.time.size(); ++k)
        worst = std::max(worst, std::abs(fast.position[k] - exact.position[k]));
    return worst;
}

Joint two_masses(double backlash = 0, double ratio = 1)
{
    Joint joint = sampled_joint();
    auto& m = joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = 0.7 / (ratio * ratio), m.link_inertia = 1.3;
    m.transmission.stiffness = 4e4, m.transmission.damping = 40;
    m.transmission.ratio = ratio, m.transmission.backlash = backlash;
    joint.control.k_p /= ratio * ratio, joint.control.k_v /= ratio * ratio;
    joint.frictions.motor.law = CoulombViscous{3 / ratio, 6 / (ratio * ratio)};
    joint.frictions.link.law = CoulombViscous{2, 4};
    return joint;
}

Friction with_memory(double A, double B, MemoryForm form)
{
    Friction f;
    f.law = CoulombViscous{5, 10};
    f.memory.A = A, f.memory.B = B, f.memory.L = 1e-4, f.memory.V_star = 1e-3, f.memory.form = form;
    return f;
}

}  // namespace

TEST_CASE("both simulators: laws", "[gap][two-simulators][slow]")
{
    RateAndStateRegularised regularised;
    regularised.f0 = 5, regularised.A = 0.1, regularised.V_star = 1e-3;
    regularised.B.push_back(0.3), regularised.L.push_back(1e-4);
    std::map<std::string, Friction> frictions;
    frictions["coulomb-viscous"].law = CoulombViscous{5, 10};
    frictions["kinetic-static"].law = KineticStatic{5, 7};
    frictions["stribeck"].law = Stribeck{5, 10, 2, 0.02, 2};
    frictions["lugre"].law = LuGre{3e4, 200, 10, 5, 7, 0.02};
    frictions["dahl"].law = Dahl{5, 3e4, 1};
    frictions["regularised"].law = regularised;
    frictions["memory of the slip law"] = with_memory(0.1, 0.3, MemoryForm::slip);
    frictions["memory of the ageing law"] = with_memory(0.1, 0.3, MemoryForm::ageing);
    frictions["memory without a direct effect"] = with_memory(0, 0.3, MemoryForm::slip);
    for (const bool whole : {false, true}) {
        auto& f = frictions[whole ? "lag of the force" : "lag of the level"];
        f.law = Stribeck{5, 10, 2, 0.02, 2};
        f.memory.lag = 5e-3, f.memory.lag_viscous = whole;
    }
    frictions["bristles"].law = CoulombViscous{5, 10};
    frictions["bristles"].bristle = {3e4, 200};
    frictions["load coefficient"].law = CoulombViscous{5, 10};
    frictions["load coefficient"].load_coefficient = 0.2;
    frictions["ripple"].law = CoulombViscous{5, 10};
    frictions["ripple"].ripple = {1, 150, 0.3};
    frictions["two harmonics"].law = CoulombViscous{5, 10};
    frictions["two harmonics"].ripple = {1, 150, 0.3, 0.6, -1.1};
    frictions["second harmonic alone"].law = CoulombViscous{5, 10};
    frictions["second harmonic alone"].ripple = {0, 150, 0, 0.8, 0.4};
    frictions["drift"].law = CoulombViscous{5, 10};
    frictions["drift"].drift = {-2, 1};
    frictions["asymmetry"].law = CoulombViscous{5, 10};
    frictions["asymmetry"].asymmetry = {0.7, 0.5};
    frictions["gear"].law = CoulombViscous{5, 10};
    frictions["gear"].gear = {0.1, 0.5, 0.7};
    for (const auto& [name, friction] : frictions) {
        Joint joint = sampled_joint();
        joint.friction = friction;
        if (name == "gear") joint.mechanism.motion = Motion::revolute, joint.load.gravity_amplitude = 8;
        CAPTURE(name);
        CHECK(difference(joint) < 3e-7);
    }
}

TEST_CASE("both simulators: elements of the loop and bodies", "[gap][two-simulators]")
{
    std::map<std::string, Joint> joints;
    const auto with = [&](const std::string& name, auto&& change) {
        joints[name] = sampled_joint();
        change(joints[name]);
    };
    with("part of a tick of dead time", [](Joint& j) { j.control.delay = 2.4e-3; });
    with("late readings", [](Joint& j) { j.sensor.delay = 1.6e-3; });
    with("lag", [](Joint& j) { j.actuator.lag = 4e-3; });
    with("mean of readings", [](Joint& j) { j.control.velocity_estimate.average = 4; });
    with("exact velocity", [](Joint& j) { j.control.velocity_estimate.form = EstimateForm::exact; });
    with("limits", [](Joint& j) { j.control.effort_limit = 25, j.actuator.limit = 20; });
    with("gain and sag", [](Joint& j) { j.actuator.effort_gain = 1.3, j.actuator.sag_effort = 200; });
    with("integral", [](Joint& j) { j.control.k_i = 2e4; });
    with("dead zone", [](Joint& j) { j.control.dead_zone = 5e-4; });
    with("encoder", [](Joint& j) { j.sensor.position_scale = 1.1, j.sensor.position_offset = 0.01; });
    with("loads", [](Joint& j) {
        j.load.constant = -4, j.load.cogging = {1, 150, 0.3}, j.load.disturbance = {1, 20, 0.3};
    });
    with("cogging of two harmonics", [](Joint& j) { j.load.cogging = {1, 150, 0.3, 0.6, -1.1}; });
    with("gravity", [](Joint& j) { j.mechanism.motion = Motion::revolute, j.load.gravity_amplitude = 8; });
    joints["two masses"] = two_masses();
    joints["two masses behind a gear"] = two_masses(0, 5);
    joints["backlash"] = two_masses(1e-3);
    joints["a spring that hardens"] = two_masses(0, 5);
    joints["a spring that hardens"].mechanism.transmission.cubic_stiffness = 4e4 / std::pow(5e-4, 2);
    joints["a spring that hardens behind backlash"] = two_masses(1e-3);
    joints["a spring that hardens behind backlash"].mechanism.transmission.cubic_stiffness = 4e4 / std::pow(5e-4, 2);
    joints["bristles of the link"] = two_masses();
    joints["bristles of the link"].frictions.link.bristle = {3e4, 200};
    joints["load on the link's friction"] = two_masses();
    joints["load on the link's friction"].frictions.link.load_coefficient = 0.2;
    joints["Stribeck of the link"] = two_masses();
    joints["Stribeck of the link"].frictions.link.law = Stribeck{2, 4, 1, 0.02, 2};
    joints["memory of the link"] = two_masses();
    joints["memory of the link"].frictions.link = with_memory(0.1, 0.3, MemoryForm::slip);
    joints["static friction of the link"] = two_masses();
    joints["static friction of the link"].frictions.link.law = KineticStatic{2, 3};
    for (const auto& [name, joint] : joints) {
        CAPTURE(name);
        CHECK(difference(joint) < 1e-6);
    }
}

// A LuGre joint whose encoder resolves 1e-5 of its travel has a gap where its own record is simulated less well.
TEST_CASE("both simulators: bristles from soft to stiff, to 1e-5 of the travel", "[gap][two-simulators][slow]")
{
    for (const double stiffness : {1e3, 3e4, 1e6})
        for (const double damping : {0.0, 200.0})
            for (const double velocity : {0.005, 0.05}) {
                Joint joint = sampled_joint();
                joint.friction.law = LuGre{stiffness, damping, 10, 5, 8, velocity};
                CAPTURE(stiffness, damping, velocity);
                CHECK(difference(joint) < 1e-6);
            }
}

// A spring that a moving link has stretched, and a bristle that has bent, are there from the first row on.
TEST_CASE("both simulators: records that begin in motion", "[gap][two-simulators]")
{
    Joint bristles = sampled_joint();
    bristles.friction.law = LuGre{3e3, 50, 10, 5, 7, 0.02};
    for (Joint joint : {two_masses(), two_masses(0, 5), bristles}) {
        joint.control.delay = 0;
        const auto exact = record_along(joint, lively(3, 1e-3), 0);
        REQUIRE(exact.reason == Reason::none);
        Record record;
        const std::size_t first = 200;
        const auto rest_of = [&](const std::vector<double>& all) {
            return std::vector<double>(all.begin() + first, all.end());
        };
        record.time = rest_of(exact.time), record.position = rest_of(exact.position);
        record.reference_position = rest_of(exact.reference_position);
        record.reference_velocity = rest_of(exact.reference_velocity);
        const Joint written = record_form(joint);
        Ticks ticks = on_clock(record, written);
        start_moving(ticks);
        const auto fast = simulate_closed_loop(flatten(written), ticks, 0);
        double worst = 0;
        for (std::size_t k = 0; k < record.time.size(); ++k)
            worst = std::max(worst, std::abs(fast.position[k] - record.position[k]));
        CAPTURE(joint.mechanism.transmission.ratio);
        CHECK(worst < 1e-5);
    }
}
