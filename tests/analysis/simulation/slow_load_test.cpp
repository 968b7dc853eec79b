// Loads that change slowly with the position, held at places: against closed forms, and against the motion through all
// places where that can be followed.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/attractor/slow_load.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <algorithm>
#include <cmath>

using namespace stickslip;

namespace {

Joint pendulum(double gravity, double V0)
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute;
    joint.mechanism.inertia = 2;
    joint.control.k_p = 800, joint.control.k_v = 400, joint.control.V0 = V0;
    joint.friction.law = CoulombViscous{.coulomb = 5, .viscous = 20};
    joint.load.gravity_amplitude = gravity;
    return joint;
}

}  // namespace

TEST_CASE("slow load: a pendulum that turns slowly is as slow to come back as where gravity pushes it on",
          "[slow-load]")
{
    const auto joint = pendulum(100, 1e-4);  // a turn takes seventeen hours
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.region == NonlinearRegion::stable);
    CHECK(verdict.held_places == 4);
    CHECK(verdict.places_alike);
    const double damping = 420, stiffness = 800 - 100;
    CHECK(verdict.growth_rate ==
          Approx((-damping + std::sqrt(damping * damping - 4 * 2 * stiffness)) / (2 * 2)).epsilon(1e-3));
}

TEST_CASE("slow load: a gain between those that hold with and against gravity sticks and slips somewhere",
          "[slow-load]")
{
    const double k_cr = linear_verdict(differencing_joint(1e4, 0)).state_variable.k_cr;
    for (const double part : {0.85, 1.05, 1.2}) {
        Joint joint = differencing_joint(part * k_cr, 0);
        joint.control.velocity_estimate = {};
        joint.mechanism.motion = Motion::revolute;
        joint.load.gravity_amplitude = 0.1 * k_cr;
        CAPTURE(part);
        const auto verdict = nonlinear_verdict(joint, {});
        CHECK(verdict.held_places == 4);
        CHECK((verdict.region == NonlinearRegion::stick_slip) == (part < 1.1));
        CHECK(verdict.places_alike == (part != 1.05));
    }
}

TEST_CASE("slow load: held at its places it is what the motion through all of them shows", "[slow-load][slow]")
{
    Joint joint = pendulum(40, 0.12);
    joint.control.k_v = 4;
    joint.friction.law = Stribeck{.c0 = 5, .c1 = 2, .c2 = 4, .c3 = 0.2, .c4 = 1};
    CHECK(held_where_load_is_slow(joint).places.empty());
    const auto followed = nonlinear_verdict(joint, {});
    std::vector<NonlinearVerdict> places;
    const auto held = held_at_places(joint);
    for (const Joint& place : held.places) places.push_back(nonlinear_verdict(place, {}));
    REQUIRE(places.size() == 4);
    const auto worst = worst_of(places, held.repeats_after);
    REQUIRE(worst);
    CHECK(followed.outcome == worst->outcome);
    CHECK(worst->places_alike);
    const auto [least, most] = std::ranges::minmax(places, {}, &NonlinearVerdict::amplitude);
    // that of the whole motion has what gravity winds the spring up by, to either side
    const double wound = 40.0 / 800;
    CHECK(followed.amplitude - wound > 0.93 * least.amplitude);
    CHECK(followed.amplitude - wound < 1.03 * most.amplitude);
}

TEST_CASE("slow load: what changes within some turns of the joint is not held", "[slow-load]")
{
    const auto places = [](const Joint& joint) { return held_where_load_is_slow(joint).places.size(); };
    CHECK(places(pendulum(40, 0.5)) == 0);
    auto pushed = pendulum(40, 1e-4);
    CHECK(places(pushed) == 4);
    pushed.control.force_rate = 1;
    CHECK(places(pushed) == 0);
    CHECK(places(pendulum(0, 1e-4)) == 0);
    NonlinearVerdict slow;
    slow.period = 2;
    CHECK(worst_of({slow}, 201));
    CHECK_FALSE(worst_of({slow}, 199));
}
