// Loads and friction that change slowly, held at places: against closed forms, and against the motion through all
// places where that can be followed.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/attractor/slow_changes.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/friction/sample_laws.h"
#include "tests/analysis/simulation/joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

TEST_CASE("slow changes: a pendulum that turns slowly is as slow to come back as where gravity pushes it on",
          "[slow-changes]")
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

TEST_CASE("slow changes: a gain between those that hold with and against gravity sticks and slips somewhere",
          "[slow-changes]")
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

TEST_CASE("slow changes: held at its places it is what the motion through all of them shows", "[slow-changes][slow]")
{
    Joint joint = pendulum(40, 0.12);
    joint.control.k_v = 4;
    joint.friction.law = Stribeck{.c0 = 5, .c1 = 2, .c2 = 4, .c3 = 0.2, .c4 = 1};
    CHECK(held_where_changes_are_slow(joint).places.empty());
    const auto followed = nonlinear_verdict(joint, {});
    std::vector<NonlinearVerdict> places;
    Joint slow = joint;  // its places are the same
    slow.control.V0 = 1e-4;
    for (Joint place : held_where_changes_are_slow(slow).places) {
        place.control.V0 = joint.control.V0;
        places.push_back(nonlinear_verdict(place, {}));
    }
    REQUIRE(places.size() == 4);
    const auto worst = worst_of(places, 2 * std::numbers::pi / joint.control.V0);
    REQUIRE(worst);
    CHECK(followed.outcome == worst->outcome);
    CHECK(worst->places_alike);
    const auto [least, most] = std::ranges::minmax(places, {}, &NonlinearVerdict::amplitude);
    // that of the whole motion has what gravity winds the spring up by, to either side
    const double wound = 40.0 / 800;
    CHECK(followed.amplitude - wound > 0.93 * least.amplitude);
    CHECK(followed.amplitude - wound < 1.03 * most.amplitude);
}

TEST_CASE("slow changes: what changes within some turns of the joint is not held", "[slow-changes]")
{
    const auto places = [](const Joint& joint) { return held_where_changes_are_slow(joint).places.size(); };
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

TEST_CASE("slow changes: a wave of the friction softens the spring of the gain where it falls along the way",
          "[slow-changes]")
{
    const auto joint_at = [](double k_p, double V0) {
        Joint joint;
        joint.mechanism.inertia = 1;
        joint.control.k_p = k_p, joint.control.V0 = V0;
        joint.friction.law = samples::regularised(MemoryForm::slip);
        return joint;
    };
    const double k_cr = linear_verdict(joint_at(1e4, 1e-4)).state_variable.k_cr;
    for (const double V0 : {1e-4, -1e-4})
        for (const double part : {0.85, 1.05, 1.2}) {
            Joint joint = joint_at(part * k_cr, V0);
            // k_cr is that of the spring with the slope of the wave, a tenth of it to either side
            joint.friction.ripple = {.amplitude = 1e-3 * k_cr, .periods = 100, .phase = 0.3};
            CAPTURE(part, V0);
            const auto verdict = nonlinear_verdict(joint, {});
            CHECK(verdict.held_places == 4);
            CHECK((verdict.region == NonlinearRegion::stick_slip) == (part < 1.1));
            CHECK(verdict.places_alike == (part != 1.05));
        }
}

namespace {

/// Slides on its own; where its static friction (9 N) is beyond the effort limit, it stays where it comes to rest.
Joint limited_joint()
{
    Joint joint;
    joint.mechanism.inertia = 2;
    joint.control.k_p = 800, joint.control.k_v = 200, joint.control.V0 = 1e-3, joint.control.effort_limit = 12;
    joint.friction.law = Stribeck{.c0 = 5, .c1 = 2, .c2 = 4, .c3 = 1e-4, .c4 = 2};
    return joint;
}

}  // namespace

TEST_CASE("slow changes: a level that drifts beyond the effort limit holds the joint once it rests", "[slow-changes]")
{
    CHECK(nonlinear_verdict(limited_joint(), {}).region == NonlinearRegion::stable);
    for (const double change : {2.0, 6.0})
        for (const double time_constant : {1e-3, 5e3}) {
            Joint joint = limited_joint();
            joint.friction.drift = {change, time_constant};
            CAPTURE(change, time_constant);
            const auto verdict = nonlinear_verdict(joint, {});
            CHECK(verdict.held_places == (time_constant < 1 ? 1 : 2));
            CHECK(verdict.region == (change > 3 ? NonlinearRegion::bistable : NonlinearRegion::stable));
            CHECK(verdict.comes_to_rest() == (change > 3));
            CHECK(verdict.places_alike == (change < 3 || time_constant < 1));
        }
}

TEST_CASE("slow changes: a slow force holds the joint where it and static friction are beyond the effort limit",
          "[slow-changes]")
{
    for (const double amplitude : {2.0, 4.0}) {
        Joint joint = limited_joint();
        joint.load.disturbance = {.amplitude = amplitude, .frequency = 1e-3};
        CAPTURE(amplitude);
        const auto verdict = nonlinear_verdict(joint, {});
        CHECK(verdict.held_places == 4);
        CHECK(verdict.region == (amplitude > 3 ? NonlinearRegion::bistable : NonlinearRegion::stable));
        CHECK(verdict.places_alike == (amplitude < 3));
    }
}
