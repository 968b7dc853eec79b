// The mechanism against closed forms: what moves, what sticks, where energy goes.
#include "tests/blind/checks/machines.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace blind;

TEST_CASE("a pushed mass accelerates by the excess over Coulomb friction, stops when it must and then stays", "[blind]")
{
    const Machine m = sliding_mass(2, 3);
    Plant plant(m);
    plant.rest_at(0.1);
    plant.advance(0.5, constant(2.999));
    CHECK(plant.stuck(0));
    CHECK(plant.position(0) == 0.1);
    plant.advance(1.5, constant(7));  // (7 − 3)/2 for 1 s
    CHECK(plant.velocity(0) == Approx(2).epsilon(1e-9));
    CHECK(plant.position(0) == Approx(0.1 + 1).epsilon(1e-9));
    plant.advance(2.8, constant(0));  // −3/2 for 4/3 s, 4/3 m
    CHECK(plant.velocity(0) == Approx(2 - 1.5 * 1.3).epsilon(1e-7));
    plant.advance(4, constant(-2.9));
    CHECK(plant.velocity(0) == 0);
    CHECK(plant.stuck(0));
    // −2.9 joins the friction for the last 0.05 m/s: −2.95 m/s² once it is on.
    const double last = 0.05;
    CHECK(plant.position(0) == Approx(0.1 + 1 + 2 * 1.3 - 0.75 * 1.69 + last * last / (2 * 2.95)).epsilon(1e-7));
}

TEST_CASE("a pendulum without friction keeps its energy, with friction it only loses energy and comes to rest",
          "[blind]")
{
    Machine m = sliding_mass(0.2, 0);
    m.mechanism.gravity = 3;
    Plant free(m);
    free.rest_at(1.2);
    const double start = free.energy();
    for (int k = 1; k <= 5000; ++k) free.advance(k * 1e-3, constant(0));
    CHECK(free.energy() == Approx(start).epsilon(1e-6));

    m.mechanism.friction[0].coulomb = 0.3;
    m.mechanism.friction[0].static_rise = 0.1;
    m.mechanism.friction[0].stribeck_velocity = 0.2;
    Plant rubbing(m);
    rubbing.rest_at(1.2);
    double energy = rubbing.energy();
    bool falls = true;
    for (int k = 1; k <= 8000; ++k) {
        rubbing.advance(k * 1e-3, constant(0));
        falls = falls && rubbing.energy() <= energy + 1e-9;
        energy = rubbing.energy();
    }
    CHECK(falls);
    CHECK(rubbing.stuck(0));
    CHECK(std::abs(3 * std::sin(rubbing.position(0))) <= 0.4);
}

TEST_CASE("two bodies with backlash and a damped spring lose energy only", "[blind]")
{
    Machine m = sliding_mass(0.1, 0.05);
    m.mechanism.bodies = 2;
    m.mechanism.inertia[1] = 0.2;
    m.mechanism.stiffness = 4e3;
    m.mechanism.damping = 2;
    m.mechanism.backlash = 0.05;
    m.mechanism.gravity = 1;
    m.mechanism.friction[1].coulomb = 0.02;
    Plant plant(m);
    plant.rest_at(1);
    double energy = plant.energy();
    bool falls = true, apart = true;
    for (int k = 1; k <= 6000; ++k) {
        plant.advance(k * 1e-3, constant(0));
        falls = falls && plant.energy() <= energy + 1e-8;
        apart = apart && std::abs(plant.position(0) - plant.position(1)) < 0.025 + 0.01;
        energy = plant.energy();
    }
    CHECK(falls);
    CHECK(apart);
}

TEST_CASE("a motor that turns round leaves its link behind for the whole backlash", "[blind]")
{
    Machine m = sliding_mass(0.1, 0.2);
    m.mechanism.bodies = 2;
    m.mechanism.inertia[1] = 0.1;
    m.mechanism.stiffness = 1e4;
    m.mechanism.damping = 20;
    m.mechanism.backlash = 0.04;
    m.mechanism.friction[1].coulomb = 0.3;
    Plant plant(m);
    plant.rest_at(0);
    // Forward, to rest, then gently back: 0.45 moves the motor (0.2) but not motor and link (0.5).
    plant.advance(0.5, constant(1));
    plant.advance(1.2, constant(0));
    const double link = plant.position(1);
    CHECK(plant.stuck(1));
    CHECK(plant.position(0) - link > 0.02 - 1e-4);
    double t = 1.2, moved_early = 0;
    while (plant.position(0) - plant.position(1) > -0.0199 && t < 2) {
        moved_early = std::max(moved_early, std::abs(plant.position(1) - link));
        plant.advance(t += 1e-3, constant(-0.45));
    }
    CHECK(moved_early == 0);
    CHECK(t < 1.5);
    plant.advance(3, constant(-0.45));  // the impact shifts the link a little; then both hold
    CHECK(plant.stuck(0));
    CHECK(plant.stuck(1));
    CHECK(plant.position(0) - plant.position(1) < -0.02);
}

TEST_CASE(
    "a DC motor: the current solves its circuit, sagging supply included, and the speed settles where torque is "
    "friction",
    "[blind]")
{
    Drive d{.kind = Drive::Kind::dc_duty,
            .torque_constant = 0.3,
            .back_emf = 0.3,
            .resistance = 4,
            .supply = 12,
            .supply_resistance = 0.7};
    for (double duty : {-1.0, -0.4, 0.0, 0.3, 1.0})
        for (double speed : {-20.0, -3.0, 0.0, 5.0, 30.0}) {
            const auto s = drive_effort(d, duty, speed);
            CHECK(d.resistance * s.current ==
                  Approx(duty * (12 - 0.7 * std::abs(s.current)) - 0.3 * speed).margin(1e-12));
            CHECK(s.effort == Approx(0.3 * s.current));
        }
    Machine m = sliding_mass(0.01, 0.1);
    m.drive = d;
    m.drive.supply_resistance = 0;
    Plant plant(m);
    plant.rest_at(0);
    for (int k = 1; k <= 9000; ++k) plant.advance(k * 1e-3, constant(0.5));
    CHECK(plant.velocity(0) == Approx((6 - 4 * 0.1 / 0.3) / 0.3).epsilon(1e-6));
}

TEST_CASE("bristles give like a spring before the joint slides", "[blind]")
{
    Machine m = sliding_mass(1, 2);
    m.mechanism.friction[0].bristle_stiffness = 1000;
    m.mechanism.friction[0].bristle_damping = 10;
    Plant plant(m);
    plant.rest_at(0);
    for (int k = 1; k <= 2000; ++k) plant.advance(k * 1e-3, constant(k / 2000.));
    // Dahl, loaded slowly up to half the Coulomb force: σ0 x = F_c ln(1/(1 − F/F_c)).
    CHECK(plant.position(0) == Approx(2 / 1000. * std::log(2)).epsilon(0.02));
    for (int k = 2001; k <= 3000; ++k) plant.advance(k * 1e-3, constant(3));
    CHECK(plant.velocity(0) == Approx(1).epsilon(0.05));
}
