// What reaches a simulator of a joint, against numbers by hand.
#include <catch2/catch.hpp>

#include "analysis/joint/keys.h"
#include "sweep/files/simulators/simulator_text.h"
#include "sweep/study/export/export.h"
#include "sweep/study/start/starting_joint.h"
#include "sweep/words/export_text.h"

#include <algorithm>
#include <cmath>

using namespace stickslip;

namespace {

/// Motor of 2e-5 kg m² behind a gear of 50, spring, 0.01 rad of backlash.
Joint geared()
{
    Joint joint = starting_joint(Model::two_mass, "coulomb-viscous", Motion::revolute);
    auto& m = joint.mechanism;
    m.motor_inertia = 2e-5;
    m.link_inertia = 0.08;
    m.transmission.ratio = 50;
    m.transmission.stiffness = 4000;
    m.transmission.damping = 3;
    m.transmission.backlash = 0.01;
    auto& motor = std::get<CoulombViscous>(joint.frictions.motor.law);
    motor.coulomb = 0.02, motor.viscous = 1e-4;
    auto& link = std::get<CoulombViscous>(joint.frictions.link.law);
    link.coulomb = 0.5, link.viscous = 0.3;
    joint.control.k_p = 0.4;
    joint.control.k_v = 0.01;
    joint.control.effort_limit = 1.2;
    return joint;
}

bool lost(const ExportAnswer& answer, const std::string& key)
{
    return std::any_of(answer.not_expressible.begin(), answer.not_expressible.end(),
                       [&](const NotExpressible& n) { return n.key == key; });
}

}  // namespace

TEST_CASE("export: what stands at the motor's shaft is reflected by N and N²")
{
    const auto s = simulator_joint(geared());
    CHECK(s.armature == Approx(2e-5 * 2500));
    CHECK(s.motor.coulomb == Approx(0.02 * 50));
    CHECK(s.motor.viscous == Approx(1e-4 * 2500));
    CHECK(s.k_p == Approx(0.4 * 2500));
    CHECK(s.k_v == Approx(0.01 * 2500));
    CHECK(s.effort_limit == Approx(60));
    CHECK(s.friction().coulomb == Approx(1.5));
    CHECK(s.inertia() == Approx(0.13));
}

TEST_CASE("export: a DC motor is a gain, a damping by back-EMF and two ends of its line")
{
    Joint joint = starting_joint(Model::single_mass, "coulomb-viscous", Motion::revolute);
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor;
    a.k_t = 0.05, a.k_e = 0.05, a.resistance = 2, a.supply_voltage = 24;
    joint.control.k_p = 100;
    const auto s = simulator_joint(joint);
    CHECK(s.k_p == Approx(100 * 0.05 / 2));
    CHECK(s.back_emf == Approx(0.05 * 0.05 / 2));
    CHECK(s.stall_effort == Approx(0.6));
    CHECK(s.no_load_speed == Approx(480));
    CHECK(s.effort_limit == Approx(0.6));
}

TEST_CASE("export: Isaac Lab has the back-EMF of a DC motor once, and its supply as a limit of the effort")
{
    Joint joint = starting_joint(Model::single_mass, "coulomb-viscous", Motion::revolute);
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor;
    a.k_t = 5, a.k_e = 5, a.resistance = 0.5, a.supply_voltage = 48;
    std::get<CoulombViscous>(joint.friction.law).viscous = 3;
    joint.control.k_p = 100;
    for (const double delay : {0.0, 0.01}) {
        joint.control.delay = delay;
        const auto answer = export_joint(joint, Simulator::isaaclab);
        const auto text = simulator_text(answer, "elbow");
        INFO(text);
        CHECK(text.find("DCMotor") == std::string::npos);  // it would clip by speed what viscous_friction takes already
        CHECK(text.find("velocity_limit") == std::string::npos);
        CHECK(text.find("viscous_friction=53,  # 50 of it by the motor's back-EMF") != std::string::npos);
        CHECK(text.find(delay > 0 ? "effort_limit=480," : "effort_limit_sim=480,") != std::string::npos);
        // stall effort against back-EMF: at rest at 48 V / 5 V·s/rad
        CHECK(answer.joint.effort_limit / answer.joint.back_emf == Approx(9.6));
    }
    // clipped effort and damping are the motor at its supply wherever both have an element
    for (const auto& target : simulators)
        CHECK(lost(export_joint(joint, target.value), "actuator.supply_voltage") ==
              (target.value == Simulator::ros2_control));
}

TEST_CASE("export: friction without a Coulomb level is read at the commanded velocity")
{
    Joint joint = starting_joint(Model::single_mass, "rate-and-state", Motion::prismatic);
    joint.control.V0 = 1e-2;  // f0 + (A − B) ln(V/V*) with V/V* = 10
    CHECK(simulator_joint(joint).friction().coulomb == Approx(60 - 0.5 * std::log(10.)));
    SplitOptions options;
    options.speed = 1e-3;
    CHECK(simulator_joint(joint, options).friction().coulomb == Approx(60));
}

TEST_CASE("export: friction is read at the velocity at which the joint slides, and the answer says at which")
{
    Joint joint = starting_joint(Model::single_mass, "rate-and-state", Motion::prismatic);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.f0 = 60, law.A = 1, law.B = {1.5}, law.V_star = 2e-3;
    const auto level = [](double V) { return 60 - 0.5 * std::log(V / 2e-3); };
    joint.control.V0 = 0.05;
    joint.sensor.position_scale = 5;  // it slides at V_0/5
    auto s = simulator_joint(joint);
    CHECK(s.friction().speed == Approx(0.01));
    CHECK(s.friction().coulomb == Approx(level(0.01)));
    CHECK_FALSE(s.speed_assumed);
    CHECK(read_at_text(s).find("10 mm/s") != std::string::npos);
    for (const double none : {0.0, not_set}) {
        joint.control.V0 = none;
        s = simulator_joint(joint);
        CHECK(s.speed_assumed);
        CHECK(s.friction().coulomb == Approx(60));
        CHECK(read_at_text(s).find("2 mm/s") != std::string::npos);
        CHECK(read_at_text(s).find("--speed") != std::string::npos);
        SplitOptions asked;
        asked.speed = 0.02;
        CHECK(simulator_joint(joint, asked).friction().coulomb == Approx(level(0.02)));
        CHECK_FALSE(simulator_joint(joint, asked).speed_assumed);
    }
    CHECK(read_at_text(simulator_joint(geared())).empty());
}

TEST_CASE("export: what is in force and not said is listed, what is at its default is not")
{
    Joint joint = geared();
    CHECK_FALSE(lost(export_joint(joint, Simulator::mjcf), "joint.transmission.backlash"));
    CHECK_FALSE(lost(export_joint(joint, Simulator::mjcf), "friction.link.coulomb"));
    // the tendon damps across the dead band, too
    REQUIRE(export_joint(joint, Simulator::mjcf).not_expressible.size() == 1);
    CHECK(lost(export_joint(joint, Simulator::mjcf), "joint.transmission.damping"));
    for (double Transmission::*number : {&Transmission::damping, &Transmission::backlash}) {
        Joint without = joint;
        without.mechanism.transmission.*number = 0;
        CHECK(export_joint(without, Simulator::mjcf).not_expressible.empty());
    }
    const auto isaac = export_joint(joint, Simulator::isaaclab);
    CHECK(lost(isaac, "joint.transmission.backlash"));
    CHECK(lost(isaac, "joint.transmission.stiffness"));
    CHECK_FALSE(lost(isaac, "joint.motor_inertia"));
    CHECK(lost(export_joint(joint, Simulator::ros2_control), "friction.link.coulomb"));
    joint.control.delay = 0.004;
    joint.frictions.link.ripple.amplitude = 0.1;
    joint.sensor.encoder_quantum = 1e-4;
    for (const auto& target : simulators) {
        const auto answer = export_joint(joint, target.value);
        CHECK(lost(answer, "control.delay"));
        CHECK(lost(answer, "friction.link.ripple.amplitude"));
        CHECK(lost(answer, "sensor.encoder_quantum"));
        for (const auto& n : answer.not_expressible) CHECK(lost_text(answer, n).size() > 20);
    }
}

TEST_CASE("export: every law loses what it remembers, on every simulator")
{
    for (const auto& law : laws()) {
        const Joint joint = starting_joint(Model::single_mass, std::string(law.name), Motion::revolute);
        for (const auto& target : simulators) {
            const auto answer = export_joint(joint, target.value);
            const bool plain =
                law.name == std::string_view("coulomb-viscous") && target.value != Simulator::ros2_control;
            CHECK(lost(answer, "friction.law") == !plain);
            CHECK(std::isfinite(answer.joint.friction().coulomb));
            CHECK(simulator_text(answer, "elbow").find("elbow") != std::string::npos);
        }
    }
}

TEST_CASE("export: delay in steps of the simulator")
{
    Joint joint = geared();
    joint.control.delay = 0.006;
    ExportOptions options;
    options.timestep = 0.002;
    CHECK(export_joint(joint, Simulator::mjcf, options).delay_steps == 3);
    CHECK(
        simulator_text(export_joint(joint, Simulator::mjcf, options), "elbow").find("delay=\"0.006\" nsample=\"4\"") !=
        std::string::npos);
}

TEST_CASE("export: one mass can be divided into the robot's link and armature")
{
    Joint joint = starting_joint(Model::single_mass, "coulomb-viscous", Motion::revolute);
    joint.mechanism.inertia = 0.05;
    SplitOptions options;
    options.link_inertia = 0.03;
    CHECK(simulator_joint(joint, options).armature == Approx(0.02));
    options.link_inertia = 0.06;
    CHECK_THROWS_AS(simulator_joint(joint, options), std::invalid_argument);
}
