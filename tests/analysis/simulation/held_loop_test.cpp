// Loops whose limits leave less effort than breaks static friction, and loops with a wide dead zone: what the verdict
// says of the end is what the motion does.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/effort_limits.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;

namespace {

/// 4 N of Coulomb and 6 N of static friction; sliding at 5 mm/s takes 5 N, with a slope of −275 N·s/m.
Joint falling(double k_v)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    auto& c = joint.control;
    c.k_p = 2000, c.k_v = k_v, c.V0 = 5e-3;
    c.period = 1e-3;
    c.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = Stribeck{4, 2, 2, 6e-3, 2};
    return joint;
}

/// The share of the second half of a motion that is spent at rest.
double rests(const Joint& joint, const Disturbance& disturbance, double duration)
{
    SimulateOptions options;
    options.disturbance = disturbance;
    options.duration = duration;
    const auto path = simulate(joint, options);
    REQUIRE(path.reason == Reason::none);
    double still = 0, all = 0;
    for (std::size_t i = 1; i < path.time.size(); ++i) {
        if (path.time[i] < 0.5 * duration) continue;
        all += path.time[i] - path.time[i - 1];
        if (path.stuck[i]) still += path.time[i] - path.time[i - 1];
    }
    return still / all;
}

NonlinearVerdict ended(const Joint& joint, const Disturbance& disturbance)
{
    NonlinearOptions options;
    options.disturbance = disturbance;
    return nonlinear_verdict(joint, options);
}

constexpr Disturbance from_rest{DisturbanceKind::start, 0};

}  // namespace

TEST_CASE("a joint whose limit is below its static friction comes to rest for good", "[simulation][held][slow]")
{
    Joint joint = falling(20);
    joint.control.effort_limit = 5.5;
    for (const double direction : {1.0, -1.0})
        for (const double period : {1e-3, missing}) {
            joint.control.V0 = direction * 5e-3;
            joint.control.period = period;
            INFO("V_0 " << joint.control.V0 << " period " << period);
            const auto low = low_limit_at_rest(joint, joint.control.V0);
            REQUIRE(low);
            CHECK(low->path == "control.effort_limit");
            CHECK(low->needed == Approx(6));
            for (const auto& disturbance : {Disturbance{}, from_rest}) {
                const auto verdict = ended(joint, disturbance);
                CHECK(verdict.reason == Reason::none);
                CHECK(verdict.outcome == Outcome::held);
                CHECK(verdict.comes_to_rest());
                CHECK(verdict.region == NonlinearRegion::stick_slip);
            }
            CHECK(rests(joint, from_rest, 60) == 1);
        }
}

TEST_CASE("a limit above the static friction leaves stick-slip", "[simulation][held]")
{
    Joint joint = falling(20);
    joint.control.effort_limit = 6.5;
    CHECK_FALSE(low_limit_at_rest(joint, joint.control.V0));
    const auto verdict = ended(joint, from_rest);
    CHECK(verdict.outcome == Outcome::stick_slip);
    CHECK(std::isfinite(verdict.period));
    CHECK(rests(joint, from_rest, 30) < 1);
}

TEST_CASE("smooth sliding below the static friction is bistable with rest", "[simulation][held]")
{
    Joint joint = falling(600);
    joint.control.effort_limit = 5.5;
    const auto verdict = ended(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.region == NonlinearRegion::bistable);
    CHECK(verdict.comes_to_rest());
    CHECK(rests(joint, from_rest, 60) == 1);
}

TEST_CASE("a wide dead zone is waited for", "[simulation][held][slow]")
{
    // the reference needs 20 s from one side of the zone to the other
    Joint joint = falling(20);
    joint.control.k_p = 2e5;
    joint.control.dead_zone = 50e-3;
    const auto verdict = ended(joint, from_rest);
    CHECK(verdict.reason == Reason::none);
    CHECK(verdict.outcome != Outcome::held);
    CHECK(std::isfinite(verdict.period));
    CHECK(rests(joint, from_rest, 120) < 1);
}
