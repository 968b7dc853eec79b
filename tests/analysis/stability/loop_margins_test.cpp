// Disturbances, margins, root locus and resolution limits against closed forms.
#include <catch2/catch.hpp>

#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/loop_margins.h"
#include "analysis/stability/resolution.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// m = 2 kg, 6 N·s/m of viscous friction, nothing else but the loop
LinearJoint oscillator(double k_p, double k_v)
{
    LinearJoint j;
    j.inertia[0] = 2;
    j.actuated[0] = 1;
    j.friction[0].f_v = 6;
    j.k_p = k_p;
    j.k_v = k_v;
    return j;
}

}  // namespace

TEST_CASE("the answer of an oscillator to disturbances", "[stability]")
{
    const auto j = oscillator(800, 2);  // ω_0 = 20, ζ = 8/(2 √(800·2)) = 0.1
    CHECK(std::abs(disturbance_response(j, 0)) == Approx(1 / 800.0));
    const std::complex<double> s(0, 7);
    CHECK(std::abs(disturbance_response(j, s) - 1.0 / (2.0 * s * s + 8.0 * s + 800.0)) < 1e-17);
    const auto peak = response_peak(j);
    const double zeta = 0.1;
    CHECK(peak.omega == Approx(20 * std::sqrt(1 - 2 * zeta * zeta)).epsilon(1e-6));
    CHECK(peak.magnitude == Approx(1 / (800 * 2 * zeta * std::sqrt(1 - zeta * zeta))).epsilon(1e-10));
    CHECK(std::isnan(response_peak(oscillator(800, -7)).magnitude));
}

TEST_CASE("a disturbance on the link of two masses bends both springs", "[stability]")
{
    auto joint = samples::two_mass();
    joint.control.k_p = 1e5;
    const auto linear = linear_joint(joint, 1e-3);
    // at rest frequency: loop and transmission in series
    CHECK(std::abs(disturbance_response(linear, 0)) == Approx(1 / 1e5 + 1 / 1e7).epsilon(1e-12));
}

TEST_CASE("margins of the loop are distances to its boundary", "[stability]")
{
    // single mass with one state, k_cr = 55000
    auto joint = samples::single_mass(1);
    joint.control.k_p = 80000;
    const auto linear = linear_joint(joint, 1e-3);
    const auto margins = loop_margins(linear);
    CHECK(margins.gain_below == Approx(55000.0 / 80000).epsilon(1e-10));
    CHECK(margins.gain_above == infinity);
    // an oscillator: L = k/(m s² + c s), |L| = 1 at ω² = (−c² + √(c⁴ + 4m²k²))/(2m²), lag −180° + atan(c/(mω))
    const double c = 6, m = 2, k = 800;
    const double omega = std::sqrt((-c * c + std::sqrt(c * c * c * c + 4 * m * m * k * k)) / (2 * m * m));
    const auto simple = loop_margins(oscillator(k, 0));
    CHECK(simple.crossover == Approx(omega).epsilon(1e-9));
    CHECK(simple.phase == Approx(std::atan(c / (m * omega))).epsilon(1e-9));
    // unstable: no margins
    joint.control.k_p = 20000;
    CHECK(std::isnan(loop_margins(linear_joint(joint, 1e-3)).phase));
}

TEST_CASE("the root locus keeps each root in its column and crosses at k_cr", "[stability]")
{
    // fine steps: where two roots meet on the real axis they move as the square root of a step
    std::vector<double> gains;
    for (double k = 1e3; k < 1e6; k *= 1.002) gains.push_back(k);
    const auto locus = root_locus(linear_joint(samples::single_mass(1), 1e-3), gains);
    REQUIRE(locus.size() == gains.size());
    for (std::size_t i = 1; i < locus.size(); ++i) {
        double largest = -infinity;
        for (std::size_t k = 0; k < 3; ++k) {
            largest = std::max(largest, locus[i][k].real());
            CHECK(std::abs(locus[i][k] - locus[i - 1][k]) < 0.2 * std::abs(locus[i][k]));
        }
        CHECK((largest < 0) == (gains[i] > 55000));
    }
}

TEST_CASE("k_v for a range of velocities is the hardest one's", "[stability]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = Stribeck{10, 5, 4, 1e-2, 2};
    const auto whole = velocity_gain_for_range(joint, 1);
    CHECK(whole.velocity == Approx(1e-2 / std::sqrt(2.0)).epsilon(1e-6));                       // (25)
    CHECK(whole.k_v == Approx(std::sqrt(2.0) * 4 / 1e-2 * std::exp(-0.5) - 5).epsilon(1e-12));  // (26)
    // a range that ends below V_cr is hardest at its end
    const auto slow = velocity_gain_for_range(joint, 2e-3);
    CHECK(slow.velocity == Approx(2e-3));
    CHECK(slow.k_v == Approx(2 * 4 * 2e-3 / 1e-4 * std::exp(-0.04) - 5).epsilon(1e-12));
}

TEST_CASE("the least velocity of a single mass", "[stability]")
{
    // slip law: k_cr = ((B − A − k_v V)/L)(1 + mV/(L C)), C = k_v + A/V. At k_p = 60000, k_v = 0, all stable up to
    // 50000 (1 + 100 V·V·1e3…) = 60000: V² = 0.2 L A/m
    Joint joint = samples::single_mass(1);
    joint.control.k_p = 60000;
    const auto memory = stable_velocities(joint, 1e-6, 1e-1, Theory::state_variable);
    REQUIRE(memory.intervals.size() == 1);
    CHECK(memory.least == 1e-6);
    CHECK(memory.intervals[0].high == Approx(std::sqrt(0.2 * 1e-5)).epsilon(1e-9));
    CHECK(std::isnan(memory.all_above));
    // velocity-only: k_v > (B − A)/V, whatever k_p
    joint.control.k_v = 50;
    joint.control.kind = ControlKind::force;
    joint.control.contact_stiffness = 0;
    const auto simple = stable_velocities(joint, 1e-6, 1, Theory::velocity_only);
    CHECK(simple.least == Approx(0.01).epsilon(1e-9));
    CHECK(simple.all_above == simple.least);
    CHECK(simple.least_force_rate == Approx(0.01 * 60000).epsilon(1e-9));
    // a Stribeck curve without damping is stable again where it rises
    joint.friction.law = Stribeck{10, 5, 4, 1e-2, 2};
    joint.control.k_v = 0;
    CHECK(stable_velocities(joint, 1e-3, 1, Theory::state_variable).all_above > 1e-2);
}

TEST_CASE("stiffer springs give smaller velocities and stability at a constant rate of force", "[stability]")
{
    // slip law, quasi-static, k_v = 0: k_cr = (B − A)/L whatever the velocity; with inertia V = r/k gives
    // k = ((B − A)/L)(1 + m r²/(k² L A)), a cubic in k: k³ − k_0 k² − k_0 m r²/(L A) = 0
    Joint joint = samples::single_mass(1);
    joint.control.kind = ControlKind::force;
    const double rate = 500, k_0 = 5e4, inertia_term = k_0 * 1 * rate * rate / (1e-5 * 1);
    const auto memory = stable_springs(joint, rate, 1e3, 1e8, Theory::state_variable);
    REQUIRE(memory.size() == 1);
    const double k = memory[0].low;
    CHECK(k * k * k - k_0 * k * k == Approx(inertia_term).epsilon(1e-8));
    CHECK(memory[0].high == 1e8);
    // velocity-only asks for k_v > (B − A) k/r: the stiffer the spring, the more damping, so stiff springs are
    // forbidden
    joint.control.k_v = 100;
    const auto simple = stable_springs(joint, rate, 1e3, 1e8, Theory::velocity_only);
    REQUIRE(simple.size() == 1);
    CHECK(simple[0].low == 1e3);
    CHECK(simple[0].high == Approx(100 * rate / 0.5).epsilon(1e-9));
    joint.control.kind = ControlKind::position;
    CHECK_THROWS_AS(stable_springs(joint, rate, 1e3, 1e8, Theory::velocity_only), std::invalid_argument);
}
