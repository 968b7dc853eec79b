// A gear that takes a part of the effort that goes through it, another one where the load drives it.
#include "analysis/friction/friction.h"
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace stickslip;

namespace {

constexpr double forward = 0.1, backward = 0.4, inertia = 2, load = 10, other = 1.5;

/// The acceleration that is left, with all inertia beyond the gear where `beyond` is 1 and all before it where it is 0.
double acceleration(double drive, double direction, double beyond)
{
    const double net = drive - load;
    const double gear = GearLoss::level(forward, backward, beyond, load, net, direction, other);
    return (net - direction * (other + gear)) / inertia;
}

}  // namespace

// With all inertia beyond the gear, what comes out of it moves load and inertia: of what the other friction leaves of
// the drive, 1/(1 + forward) arrives; what the load gives, less the loss, is what the drive holds.
TEST_CASE("the efficiency of a gear is that of what comes out against what goes in", "[friction][gear]")
{
    const double lifting = 30, lowering = 2;
    CHECK(inertia * acceleration(lifting, 1, 1) + load == Approx((lifting - other) / (1 + forward)));
    CHECK((inertia * acceleration(lowering, -1, 1) + load) * (1 - backward) == Approx(lowering + other));
    // in steady motion the load alone goes through, wherever the inertia is
    for (const double beyond : {0.0, 0.3, 1.0}) {
        CHECK(acceleration(load * (1 + forward) + other, 1, beyond) == Approx(0).margin(1e-12));
        CHECK(acceleration(load * (1 - backward) - other, -1, beyond) == Approx(0).margin(1e-12));
    }
    // an inertia before the gear takes its own effort past it
    CHECK(inertia * acceleration(lifting, 1, 0) == Approx(lifting - other - load * (1 + forward)));
}

// Falling free, the drive off: only what accelerates the inertia before the gear goes through it.
TEST_CASE("a weight that falls free hardly feels the gear", "[friction][gear]")
{
    const double before = 0.2 * inertia;
    const double a = acceleration(0, -1, 0.8), through = load + 0.8 * inertia * a;
    CHECK(before * a == Approx(-through * (1 - backward) + other));
    CHECK(std::abs(a) > 0.7 * (load - other) / inertia);
}

TEST_CASE("a verdict without the gear's friction says so", "[friction][gear]")
{
    Joint joint;
    joint.friction.law = CoulombViscous{5, 10};
    joint.control.k_p = 100, joint.control.V0 = 0.01;
    CHECK(loop_use(joint).not_used.empty());
    joint.friction.gear.backward = 0.4;
    const auto use = loop_use(joint);
    REQUIRE(use.not_used.size() == 1);
    CHECK(use.not_used[0].key == "friction.gear");
    CHECK(use.not_used[0].matters);
}
