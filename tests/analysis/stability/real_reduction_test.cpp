// Reductions of a joint whose loop is sampled: both sides are judged in that loop, and a motor that has become an ideal
// source takes its controller with it.
#include <catch2/catch.hpp>

#include "analysis/joint/reduction.h"
#include "analysis/stability/reduction_error.h"
#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

Joint sampled_two_masses(double stiffness)
{
    Joint joint;
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = joint.mechanism.link_inertia = 0.5;
    joint.mechanism.transmission.stiffness = stiffness;
    joint.mechanism.transmission.damping = 10;
    joint.control.k_p = 6e4, joint.control.k_v = 10, joint.control.V0 = 1e-3;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    RateAndState law;
    law.f0 = 60, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5), law.L.push_back(1e-5);
    joint.frictions.link.law = law;
    joint.frictions.motor.law = CoulombViscous{0, 0};
    return joint;
}

}  // namespace

TEST_CASE("reductions of a sampled loop are compared in that loop", "[reduction]")
{
    const auto joint = sampled_two_masses(1e9);
    const auto rigid = compare_reduction(joint, rigid_transmission, "control.k_p", 1e3, 1e8, 48);
    const auto windows = linear_verdict(joint).state_variable.stable_intervals;
    REQUIRE(windows.size() == 1);
    REQUIRE(rigid.full.size() == 2);
    CHECK(rigid.full[0] == Approx(windows[0].low).epsilon(1e-12));
    CHECK(rigid.full[1] == Approx(windows[0].high).epsilon(1e-12));
    // one mass of 1 kg in a loop of 1 ms: 57140.00431 and 2344952.884 N/m
    REQUIRE(rigid.reduced.size() == 2);
    CHECK(rigid.reduced[0] == Approx(57140.00431).epsilon(1e-9));
    CHECK(rigid.reduced[1] == Approx(2344952.884).epsilon(1e-9));
    CHECK(rigid.error < 1e-2);
}

TEST_CASE("frictions side by side are judged in the loop, too", "[reduction]")
{
    auto joint = sampled_two_masses(1e9);
    joint.frictions.motor.law = Stribeck{1, 3, 0.5, 2e-3, 2};  // with rate-and-state no single law
    REQUIRE_FALSE(rigid_transmission(joint).joined.empty());
    const auto rigid = compare_reduction(joint, rigid_transmission, "control.k_p", 1e3, 1e8, 48);
    REQUIRE(rigid.full.size() == 2);
    REQUIRE(rigid.reduced.size() == 2);
    CHECK(rigid.error < 1e-2);
    auto reduced = rigid_transmission(joint);
    reduced.joint.control.k_p = rigid.reduced[0];
    CHECK(std::abs(growth_rate(reduced)) < 1e-4);
}

TEST_CASE("an ideal motor leaves a spring, which no controller samples", "[reduction]")
{
    const auto spring = two_mass_to_single_mass(sampled_two_masses(1e6)).joint;
    CHECK(loop_kind(spring) == LoopKind::ideal);
    // (27) of the paper, for one mass of 0.5 kg under the damping of the transmission
    const double m = 0.5, L = 1e-5, V = 1e-3, C = 10 + 1 / V;
    CHECK(linear_verdict(spring).state_variable.k_cr ==
          Approx((1.5 - 1 - 10 * V) / L * (1 + m * V / (L * C))).epsilon(1e-9));
}
