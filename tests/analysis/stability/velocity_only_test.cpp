// The velocity-only theory, (20)-(26).
#include <catch2/catch.hpp>

#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

Joint stribeck_joint(double V0, double k_v, double k_p = 1000)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = k_p;
    joint.control.k_v = k_v;
    joint.control.V0 = V0;
    joint.friction.law = Stribeck{10, 5, 4, 1e-2, 2};
    return joint;
}

}  // namespace

TEST_CASE("the slope is steepest where (25) says, and as steep as (26) says", "[stability]")
{
    const double V_cr = 1e-2 / std::sqrt(2.0);
    const double slope = 5 - std::sqrt(2.0) * 4 / 1e-2 * std::exp(-0.5);
    const auto verdict = linear_verdict(stribeck_joint(V_cr, 0)).velocity_only;
    CHECK(verdict.slope == Approx(slope).epsilon(1e-13));
    CHECK(verdict.k_v_min == Approx(-slope).epsilon(1e-13));
    for (const double V : {0.5 * V_cr, 0.9 * V_cr, 1.1 * V_cr, 2 * V_cr})
        CHECK(linear_verdict(stribeck_joint(V, 0)).velocity_only.slope > slope);
}

TEST_CASE("velocity feedback above the slope stabilises and the sign of k_p decides the rest", "[stability]")
{
    const double needed = linear_verdict(stribeck_joint(5e-3, 0)).velocity_only.k_v_min;
    CHECK_FALSE(linear_verdict(stribeck_joint(5e-3, 0.999 * needed)).velocity_only.stable);
    CHECK(linear_verdict(stribeck_joint(5e-3, 1.001 * needed)).velocity_only.stable);
    CHECK_FALSE(linear_verdict(stribeck_joint(5e-3, 1.001 * needed, -1)).velocity_only.stable);
}

TEST_CASE("without memory both theories are one", "[stability]")
{
    for (const double k_v : {0.0, 100.0, 300.0, 400.0}) {
        const auto verdict = linear_verdict(stribeck_joint(5e-3, k_v));
        CHECK(verdict.velocity_only.stable == verdict.state_variable.stable);
        CHECK(verdict.state_variable.f_v == verdict.velocity_only.slope);
        CHECK(verdict.state_variable.crossings.empty());
    }
}

TEST_CASE("a force ramp slides at force_rate / k_p", "[stability]")
{
    Joint joint = stribeck_joint(not_set, 0, 2000);
    joint.control.kind = ControlKind::force;
    joint.control.force_rate = 8;
    CHECK(linear_verdict(joint).steady.velocity == 8.0 / 2000);
    joint.control.force_rate = not_set;
    CHECK(linear_verdict(joint).steady.reason == Reason::no_velocity);
}
