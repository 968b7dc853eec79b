// Gears and dirt: what is told of the motor's side obeys the motor's own equations, forms outside the catalogue their
// closed forms, and a weathered log is still a log.
#include "tests/blind/checks/machines.h"
#include "tests/blind/generate/dirty.h"
#include "tests/blind/generate/geared.h"
#include "tests/blind/generate/nominal.h"
#include "tests/blind/generate/random.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace blind;

namespace {

/// A stiff two-mass servo behind a reduction.
Machine geared_servo(double reduction)
{
    Machine m = servo();
    m.mechanism.bodies = 2;
    m.mechanism.inertia[0] = 0.06, m.mechanism.inertia[1] = 0.04;
    m.mechanism.stiffness = 1e4, m.mechanism.damping = 5;
    m.reduction = reduction;
    return m;
}

}  // namespace

TEST_CASE("behind a reduction the motor's log obeys Newton's law with the link's inertia over N squared", "[blind]")
{
    Machine m = geared_servo(50);
    m.mechanism.friction[0] = m.mechanism.friction[1] = {};
    const Machine motor = at_motor(m);
    const Record r = at_motor(run_loop(m, sine(0.3, 1, 3), 1), m);
    const double inertia = motor.mechanism.inertia[0] + m.mechanism.inertia[1] / (50 * 50);
    CHECK(motor.mechanism.inertia[0] == Approx(0.06 / 2500));
    double error = 0, size = 0;
    const std::size_t wide = 20;
    for (std::size_t k = 500; k + wide < r.size(); k += wide) {
        const double T = m.controller.period * static_cast<double>(wide);
        const double bend = (r.position[k + wide] - 2 * r.position[k] + r.position[k - wide]) / (T * T);
        error = std::max(error, std::abs(inertia * bend - r.effort[k])), size = std::max(size, std::abs(r.effort[k]));
    }
    CHECK(error < 0.03 * size);
    // and the motor's controller gives its command
    for (const std::size_t k : {700, 1500, 2300}) {
        const double rate = m.controller.reference_velocity ? r.reference_velocity[k] : 0;
        CHECK(r.command[k] == Approx(motor.controller.k_p * (r.reference_position[k] - r.position[k]) +
                                     motor.controller.k_v * (rate - r.velocity[k])));
    }
}

TEST_CASE("Maxwell slip is a spring at first and Coulomb's level in the end", "[blind]")
{
    Machine m = sliding_mass(1e-3, 2);
    m.mechanism.friction[0].bristle_stiffness = 1000;
    m.mechanism.friction[0].elements = slip_elements;
    m.mechanism.friction[0].viscous = 0.5;  // the mass comes to rest on its springs
    Plant plant(m);
    plant.rest_at(0);
    plant.advance(1, constant(0.1));  // below the first element's slip: all four carry, (2.2 + 1 + 0.5 + 0.3)/4 of k
    CHECK(plant.position(0) == Approx(0.1 / 1000).epsilon(1e-3));
    plant.advance(3, constant(2.5));  // 0.5 beyond the level, against 0.5 N·s/m
    CHECK(plant.velocity(0) == Approx(1).epsilon(1e-3));
}

TEST_CASE("a weathered log keeps its order, loses its share of rows and begins in motion", "[blind]")
{
    Draw draw(3);
    const Nominal n = draw_nominal("revolute", draw);
    Dirt d = draw_dirt(n, 1, true, draw);
    d.cut = {0.7}, d.lost = 5e-3, d.jitter = 0.05, d.milliseconds = false;
    const Record whole = run_loop(n.machine, sine(0.2, 0.5, 10), 1);
    const Record r = weathered(whole, d, 0, n.machine.controller.period);
    CHECK(r.time.front() == Approx(0.7).margin(2e-3));
    for (std::size_t k = 1; k < r.size(); ++k) REQUIRE(r.time[k] > r.time[k - 1]);
    const double left = static_cast<double>(r.size()) / (static_cast<double>(whole.size()) * 9.3 / 10);
    CHECK(left < 1);
    CHECK(left > 0.98);
    CHECK(r.position.size() == r.size());
    d.milliseconds = true;
    CHECK(weathered(whole, d, 0, n.machine.controller.period).time.back() == Approx(1e3 * r.time.back()));
}

TEST_CASE("soiled machines are off by what the truth says, and by 2 to 10 per cent", "[blind]")
{
    Draw draw(5);
    const Nominal n = draw_nominal("two-mass", draw);
    const Dirt d = draw_dirt(n, 2, true, draw);
    Machine m = n.machine;
    soil(m, n, d, 0);
    for (const auto& p : corrections(n, d)) {
        if (p.nominal == 0) {  // nobody documents that friction is uneven
            CHECK(p.value == m.mechanism.friction[0].uneven_coulomb);
            CHECK(std::abs(p.value) <= 0.03 * n.coulomb());
            continue;
        }
        const double off = std::abs(p.value / p.nominal - 1);
        CHECK(off >= 0.02);
        CHECK(off <= 0.1);
    }
    CHECK(m.mechanism.inertia[1] == Approx(d.inertia * n.machine.mechanism.inertia[1]));
    CHECK(m.mechanism.friction[0].ripple.amplitude > 0);
}
