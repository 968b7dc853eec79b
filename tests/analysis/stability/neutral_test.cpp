// Neutral sliding: a root exactly on the imaginary axis, which rounding must not judge.
#include <catch2/catch.hpp>

#include <cmath>

#include "analysis/boundary/trace/locate.h"
#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// Friction that steady sliding neither feeds nor damps: m s² + k_p = 0, beside roots of its own.
std::vector<FrictionLaw> without_damping()
{
    std::vector<FrictionLaw> laws{KineticStatic{10, 15}, CoulombViscous{7, 0},
                                  LuGre{1e5, std::sqrt(1e5), 0, 1, 1, 1e-3}, LuGre{3.7e9, 1e6, 0, 0.3, 0.3, 1e-3},
                                  samples::time_lag(Stribeck{10, 0, 4, 1e-4, 2})};
    for (const double sigma0 : {1e3, 1e5, 7e9})
        for (const double coulomb : {1.0, 0.3, 10.7}) laws.emplace_back(Dahl{coulomb, sigma0, 1});
    return laws;
}

Joint undamped(const FrictionLaw& law, double k_p, double V0)
{
    Joint joint = samples::single_mass(1.3);
    joint.friction.law = law;
    joint.control.k_p = k_p;
    joint.control.V0 = V0;
    return joint;
}

}  // namespace

TEST_CASE("friction without slope and memory is neutral at every k_p and velocity", "[stability]")
{
    for (const auto& law : without_damping())
        for (const double k_p : {1.0, 123.0, 6e4, 3.3e7})
            for (const double V0 : {1e-3, 7e-3}) {
                const Joint joint = undamped(law, k_p, V0);
                CAPTURE(law.index(), k_p, V0);
                const auto verdict = linear_verdict(joint);
                const auto& memory = verdict.state_variable;
                CHECK(memory.spectral_abscissa == 0);
                CHECK(memory.neutral);
                CHECK_FALSE(memory.stable);
                CHECK(verdict.velocity_only.neutral);
                CHECK(verdict.velocity_only.k_v_min == 0);
                CHECK(memory.crossings.empty());
                CHECK(memory.stable_intervals.empty());
                CHECK(std::abs(memory.eigenvalues.front().imag()) == Approx(std::sqrt(k_p / 1.3)).epsilon(1e-12));
                const auto row = linear_point(joint);
                CHECK(row.state_variable_stable == verdict_neutral);
                CHECK(row.velocity_only_stable == verdict_neutral);
                CHECK(row.region == Region::neutral);
                CHECK(instability(joint, Curve::Kind::velocity_only) == 0);
            }
}

TEST_CASE("the least damping beside neutral sliding is told from rounding", "[stability]")
{
    // m s² + k_v s + k_p: Re s = −k_v/2m
    for (const auto& law : without_damping())
        for (const double share : {1e-3, 1e-8, 1e-12}) {
            Joint joint = undamped(law, 6e4, 1e-3);
            joint.control.k_v = share * std::sqrt(1.3 * 6e4);
            CAPTURE(law.index(), share);
            const auto memory = linear_verdict(joint).state_variable;
            CHECK(memory.stable);
            for (const auto& s : memory.eigenvalues)
                if (s.imag() > 0) CHECK(s.real() == Approx(-joint.control.k_v / 2.6).epsilon(1e-3));
            joint.control.k_v *= -1;
            CHECK_FALSE(linear_verdict(joint).state_variable.stable);
            CHECK_FALSE(linear_verdict(joint).state_variable.neutral);
        }
}

TEST_CASE("joints of several undamped bodies are neutral, with any damping between them they are not", "[stability]")
{
    for (auto joint : {samples::two_mass(), samples::three_mass()})
        for (const double k_p : {10.0, 2e4, 5e8})
            for (const double sigma0 : {0.0, 1e6}) {
                auto& m = joint.mechanism;
                m.transmission.damping = m.motor_transmission.damping = m.transmission_link.damping = 0;
                const FrictionLaw law =
                    sigma0 > 0 ? FrictionLaw{Dahl{1.7, sigma0, 1}} : FrictionLaw{KineticStatic{10, 15}};
                joint.frictions.motor.law = joint.frictions.transmission.law = joint.frictions.link.law = law;
                joint.control.k_p = k_p;
                joint.control.k_v = 0;
                CAPTURE(joint.mechanism.model, k_p, sigma0);
                auto verdict = linear_verdict(joint);
                CHECK(verdict.state_variable.neutral);
                CHECK(verdict.state_variable.stable_intervals.empty());
                CHECK(verdict.velocity_only.neutral);
                CHECK(linear_point(joint).region == Region::neutral);
                m.transmission.damping = m.motor_transmission.damping = m.transmission_link.damping = 30;
                joint.control.k_v = 1;
                verdict = linear_verdict(joint);
                CHECK(verdict.state_variable.stable);
                CHECK(verdict.velocity_only.stable);
            }
}

TEST_CASE("without a position gain nothing brings the position back", "[stability]")
{
    // the root s = 0 of s (m s + C − G(s)); all others decay
    auto two_states = samples::rate_and_state<RateAndState>({0.5, 0.2}, {1e-5, 3e-5});
    for (auto joint : {samples::single_mass(1), samples::two_mass(), samples::nine_states()}) {
        joint.control.k_p = 0;
        joint.control.k_v = 3000;
        CAPTURE(joint.mechanism.model);
        CHECK(linear_verdict(joint).state_variable.neutral);
        joint.friction.law = two_states;
        CHECK(linear_point(joint).state_variable_stable == verdict_neutral);
    }
}

TEST_CASE("memory that undoes the direct effect leaves no slope", "[stability]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = samples::rate_and_state<RateAndState>({0.1, 0.2, 0.7});  // A = 1
    std::get<RateAndState>(joint.friction.law).L = {1e-5, 3e-5, 7e-6};
    for (const double V0 : {1e-6, 1e-3, 0.3}) {
        joint.control.V0 = V0;
        const auto simple = linear_verdict(joint).velocity_only;
        CHECK(simple.slope == 0);
        CHECK(simple.k_v_min == 0);
        CHECK(simple.neutral);
    }
}

TEST_CASE("neutral sliding has no least velocity and no stable gain", "[stability]")
{
    for (const auto& law : without_damping()) {
        const Joint joint = undamped(law, 6e4, 1e-2);
        CAPTURE(law.index());
        for (const auto theory : {Theory::velocity_only, Theory::state_variable}) {
            const auto velocities = stable_velocities(joint, 1e-5, 10, theory);
            CHECK(velocities.intervals.empty());
            CHECK(std::isnan(velocities.least));
        }
        const auto both = compare_theories(joint);
        CHECK(both.k_p_memory.empty());
        CHECK(both.k_p_velocity_only.empty());
        REQUIRE(both.k_v_memory.size() == 1);
        CHECK(both.k_v_memory[0].low < 1e-6);
    }
}

TEST_CASE("k_v for every velocity of several bodies that move as one is that of their sum", "[stability]")
{
    // (25)-(26): the hardest velocity c3/√2 asks for √2 c2 e^{−1/2}/c3 − c1
    Joint joint = samples::two_mass();
    joint.mechanism.transmission.stiffness = 1e10;
    joint.mechanism.transmission.damping = 1e3;
    joint.frictions.motor.law = CoulombViscous{1, 3};
    joint.frictions.link.law = Stribeck{10, 5, 4, 1e-2, 2};
    joint.control.k_p = 1e3;
    const auto range = velocity_gain_for_range(joint, 1, 60);
    CHECK(range.velocity == Approx(1e-2 / std::sqrt(2.0)).epsilon(1e-3));
    CHECK(range.k_v == Approx(std::sqrt(2.0) * 4 / 1e-2 * std::exp(-0.5) - 5 - 3).epsilon(1e-4));
    for (const double V0 : {1e-3, 5e-3, 7.07e-3, 1e-2, 0.5}) {
        joint.control.V0 = V0;
        joint.control.k_v = 1.01 * range.k_v;
        CHECK(linear_verdict(joint).velocity_only.stable);
    }
}
