// Friction that grows with the effort that a transmission carries, on several masses: the linear theory against
// a determinant written down here and a rigid transmission, which has a closed form.
#include <catch2/catch.hpp>
#include <complex>

#include "analysis/joint/parameters.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

constexpr double m = 0.4, M = 1.0, k = 3e5, c = 20, V0 = 1e-3, A = 1, B = 1.5, L = 1e-5;

Joint two_masses(double per_effort, bool as_normal_load)
{
    Joint joint;
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = m;
    joint.mechanism.link_inertia = M;
    joint.mechanism.transmission.stiffness = k;
    joint.mechanism.transmission.damping = c;
    joint.control.k_p = 6e4;
    joint.control.k_v = 10;
    joint.control.V0 = V0;
    joint.frictions.motor.law = CoulombViscous{1, 5};
    RateAndState law;
    law.f0 = 60, law.A = A, law.V_star = V0;
    law.B.push_back(B), law.L.push_back(L);
    joint.frictions.link.law = law;
    if (as_normal_load)
        joint.normal.from_load = per_effort, joint.normal.mu = 1;
    else
        joint.frictions.link.load_coefficient = per_effort;
    return joint;
}

/// Link friction (A/V − B/L/(s + V/L)) s; the spring carries K = k + c s per stretch, of which the link's friction
/// takes the share μ.
std::complex<double> determinant(std::complex<double> s, double k_p, double k_v, double mu)
{
    const auto K = k + c * s, f = A / V0 - B / L / (s + V0 / L);
    const auto motor = m * s * s + (5 + k_v) * s + k_p + K, link = M * s * s + f * s + (1 - mu) * K;
    return motor * link - K * K * (1 - mu);
}

}  // namespace

TEST_CASE("friction per transmitted effort on several masses: roots of the determinant by hand", "[load]")
{
    for (const bool as_normal_load : {false, true})
        for (const double mu : {0.1, 0.3, -0.2}) {
            if (mu < 0 && !as_normal_load) continue;
            const auto joint = two_masses(mu, as_normal_load);
            const auto verdict = linear_verdict(joint).state_variable;
            REQUIRE(verdict.eigenvalues.size() == 5);
            for (const auto& s : verdict.eigenvalues) {
                const auto size = std::abs(determinant(s * 1.001, joint.control.k_p, joint.control.k_v, mu));
                CHECK(std::abs(determinant(s, joint.control.k_p, joint.control.k_v, mu)) < 1e-7 * size);
            }
        }
}

TEST_CASE("behind a rigid transmission the load's share is that of one mass, in closed form", "[load]")
{
    for (const double mu : {0.0, 0.1, 0.3}) {
        auto joint = two_masses(mu, false);
        joint.mechanism.transmission.stiffness = 1e13;
        const double share = 1 - mu, inertia = m + M / share;
        const double C = 10 + 5 + A / share / V0, excess = (B - A) / share - (10 + 5) * V0;
        const double k_cr = excess / L * (1 + inertia * V0 / (L * C));
        const auto verdict = linear_verdict(joint);
        CHECK(verdict.state_variable.k_cr == Approx(k_cr).epsilon(1e-6));
        CHECK(verdict.steady.deflection == Approx((1 + 5 * V0 + 60 / share) / joint.control.k_p).epsilon(1e-12));
    }
}

TEST_CASE("a load that carries the link turns the sign of friction per effort", "[load]")
{
    auto joint = two_masses(0.2, false);
    const double along = growth_rate(joint);
    joint.load.constant = 100;  // more than the link's friction: the spring holds the link back
    const double against = growth_rate(joint);
    joint.frictions.link.load_coefficient = 0;
    joint.normal.from_load = -0.2, joint.normal.mu = 1;
    joint.load.constant = 0;
    CHECK(against == Approx(growth_rate(joint)).epsilon(1e-12));
    CHECK(std::abs(along - against) > 1e-3 * std::abs(along));
}

TEST_CASE("friction per effort where nothing is steady has a reason", "[load]")
{
    auto joint = two_masses(0.2, false);
    joint.control.kind = ControlKind::force;
    CHECK(steady_sliding(joint).reason == Reason::unsupported);
    joint = two_masses(1.0, false);
    CHECK(steady_sliding(joint).reason == Reason::no_steady_state);
    joint = two_masses(0.2, true);
    joint.normal.alpha = 0.1;
    CHECK(steady_sliding(joint).reason == Reason::unsupported);
}
