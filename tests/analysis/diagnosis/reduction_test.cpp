#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/corrections.h"
#include "analysis/diagnosis/fit/joint_edits.h"
#include "analysis/diagnosis/heldout/drive_force.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/verdict/locate_stages.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <string_view>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double T = 1e-3, motor = 2e-5, link = 0.3, N = 120;
constexpr double felt = motor + link / (N * N);  // kg·m²: what the motor turns, its link reflected by energy

/// A motor that turns a link through a reduction whose spring never stretches visibly.
Joint geared(Feedback feedback)
{
    Joint j;
    j.mechanism.motion = Motion::revolute;
    j.mechanism.model = Model::two_mass;
    j.mechanism.motor_inertia = motor;
    j.mechanism.link_inertia = link;
    j.mechanism.transmission.stiffness = 1e6;
    j.mechanism.transmission.damping = 50;
    j.mechanism.transmission.ratio = N;
    CoulombViscous none;
    none.coulomb = none.viscous = 0;
    j.frictions.motor.law = j.frictions.link.law = none;
    j.control.feedback = feedback;
    j.control.k_p = 1e-3;
    j.control.period = T;
    j.sensor.position_noise = 1e-5;
    return j;
}

/// The motor under a torque that nobody logged; the encoder sees it, or the link.
Record pushed(double torque, Feedback feedback)
{
    Record r;
    const double acceleration = torque / felt / (feedback == Feedback::link ? N : 1);
    for (int k = 0; k < 2000; ++k) {
        const double t = k * T;
        r.time.push_back(t);
        r.position.push_back(0.5 * acceleration * t * t);
        r.effort_command.push_back(0);
    }
    return r;
}

}  // namespace

TEST_CASE("behind a reduction the missing force is the motor's, whichever side the encoder sits on", "[gap]")
{
    constexpr double torque = 2e-3;
    for (const Feedback feedback : {Feedback::motor, Feedback::link}) {
        std::vector<Note> notes;
        const Case c = prepare(pushed(torque, feedback), geared(feedback), notes);
        const auto force = missing_force(c, c.joint, 100);
        CAPTURE(feedback == Feedback::link);
        CHECK(force[1000] == Approx(torque).epsilon(0.01));
    }
}

TEST_CASE("what one of everything means is that of the body which an effect acts on", "[gap]")
{
    Joint j = geared(Feedback::motor);
    std::get<CoulombViscous>(j.frictions.motor.law).coulomb = 0.01;  // 1.2 N·m at the joint
    std::get<CoulombViscous>(j.frictions.link.law).coulomb = 0.5;
    CHECK(&main_friction(j) == &j.frictions.motor);
    std::get<CoulombViscous>(j.frictions.link.law).coulomb = 1.5;
    CHECK(&main_friction(j) == &j.frictions.link);

    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(pushed(2e-3, Feedback::motor), j, notes)};
    const Scales s = scales_of(cases);
    CHECK(s.inertia == Approx(felt));
    CHECK(s.coulomb == Approx(1.5 / N));
    CHECK(unit_of(Scale::load_effort, s) == Approx(N * s.effort));
    CHECK(unit_of(Scale::friction_velocity, s) == Approx(s.velocity / N));
    CHECK(unit_of(Scale::friction_damping, s) == Approx(N * N * s.effort / s.velocity));
    CHECK(unit_of(Scale::load_wave_number, s) == Approx(N / s.position));
}

TEST_CASE("the gap is located in the motor's effort, gear and effort gain included", "[gap]")
{
    std::vector<Note> notes;
    const auto motion_rms = [&](const Joint& j, const Record& r) {
        const std::vector<Case> cases{prepare(r, j, notes)};
        for (const auto& s : locate_signals(cases, {j}))
            if (s.name == "motion") return s.rms;
        return not_set;
    };
    Joint whole;
    whole.mechanism.motion = Motion::revolute;
    whole.mechanism.inertia = felt;
    CoulombViscous none;
    none.coulomb = none.viscous = 0;
    whole.friction.law = none;
    whole.control = geared(Feedback::motor).control;
    whole.sensor.position_noise = 1e-5;
    const Record r = pushed(2e-3, Feedback::motor);
    CHECK(motion_rms(geared(Feedback::motor), r) == Approx(motion_rms(whole, r)).epsilon(0.01));

    Plant plant = flatten(whole);
    plant.actuator.kind = ActuatorKind::dc_motor;
    plant.actuator.k_t = 0.05, plant.actuator.resistance = 2, plant.actuator.supply_voltage = 24;
    plant.actuator.effort_gain = 0.8;
    CHECK(plant.effort_per_command() == Approx(0.8 * 0.05 / 2));
    plant.actuator.signal = DriveSignal::duty;
    CHECK(plant.effort_per_command() == Approx(0.8 * 0.05 / 2 * 24));
}

TEST_CASE("a command that the documented gains give exactly leaves nothing but the digits of a number", "[gap]")
{
    test::Machine m;
    m.quantum = 1e-9;  // the recursion of the velocity is then the only thing between position and command
    Joint j = test::nominal_joint();
    j.sensor.encoder_quantum = 0;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(test::record_of(m, 1, 4), j, notes)};
    CHECK(audit(cases).residual_after < 1e-11);  // the difference of two sums would end at 1e-8
}

TEST_CASE("behind a reduction friction is off in proportion on both bodies, and in parts of what the joint feels",
          "[gap]")
{
    constexpr double of_motor = 0.01, of_link = 0.5, slope_of_motor = 2e-5, slope_of_link = 0.04;
    Joint j = geared(Feedback::motor);
    j.frictions.motor.law = CoulombViscous{of_motor, slope_of_motor};
    j.frictions.link.law = CoulombViscous{of_link, slope_of_link};
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(pushed(0.1, Feedback::motor), j, notes)};
    const Scales scales = scales_of(cases);
    const Corrections corrections(cases, scales, policy::ladder.prior);
    const Candidate all = corrections.beside({}).candidate;

    // the motor's 0.01 N·m are 1.2 at the joint, and its slope counts by the square of the reduction
    const double level = N * of_motor + of_link, slope = N * N * slope_of_motor + slope_of_link;
    const std::map<std::string_view, double> one_sd{{"coulomb-level", policy::correction_prior.coulomb * level},
                                                    {"viscous", policy::correction_prior.viscous * slope},
                                                    {"constant-load", policy::correction_prior.load * level}};
    std::size_t found = 0;
    for (std::size_t i = 0; i < all.effects.size(); ++i) {
        const auto expected = one_sd.find(all.effects[i]->name);
        if (expected == one_sd.end()) continue;
        ++found;
        CAPTURE(expected->first);
        const double si = all.sd_of(i) * unit_of(all.forms[i]->parameters[0].scale, scales);
        CHECK(si == Approx(expected->second));
        Joint off = j;
        all.forms[i]->apply(off, &si);
        CHECK(coulomb_force(off.frictions.motor) / of_motor == Approx(coulomb_force(off.frictions.link) / of_link));
        CHECK(viscous_slope(off.frictions.motor) / slope_of_motor ==
              Approx(viscous_slope(off.frictions.link) / slope_of_link));
        CHECK(N * coulomb_force(off.frictions.motor) + coulomb_force(off.frictions.link) +
                  (N * N * viscous_slope(off.frictions.motor) + viscous_slope(off.frictions.link)) +
                  off.load.constant ==
              Approx(level + slope + si));
    }
    CHECK(found == one_sd.size());
}
