// Linear answers that were once wrong, found by independent code, each under the name with which it was reported. The
// numbers are those of that code: its own Newton's method on the determinant, its own winding numbers.
#include "analysis/stability/characteristic.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/study.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/toml/joint_file.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace stickslip;

namespace {

Joint found(const std::string& name)
{
    return read_joint("tests/sweep/found/" + name + ".toml");
}

bool holds(const std::vector<Interval>& set, double value)
{
    for (const auto& i : set)
        if (value > i.low && value < i.high) return true;
    return false;
}

/// At gains all over the range the verdict of the joint with that gain is what the stable set says of it.
void check_gains(Joint joint, double low, double high)
{
    const auto stable = linear_verdict(joint).state_variable.stable_intervals;
    constexpr int gains = 60;
    for (int i = 0; i <= gains; ++i) {
        joint.control.k_p = low * std::pow(high / low, double(i) / gains);
        CAPTURE(joint.control.k_p);
        const double growth = growth_rate(joint);
        if (growth != 0) CHECK(holds(stable, joint.control.k_p) == (growth < 0));
    }
}

/// Roots of one body's m s² + (k_v + f_v − G) s + k_p right of Re s = σ, by brute force: the turns of F on a fine grid,
/// finest at low frequencies, where roots lie close to the line. Poles of G that lie right of the line are roots of its
/// denominator, not of the joint.
int brute_count(const LinearJoint& j, double sigma, double end, int steps)
{
    const auto F = [&](double omega) {
        const Complex s(sigma, omega);
        return (j.inertia[0] * s + j.k_v + j.friction[0].f_v - transfer(j.friction[0], s)) * s + j.k_p + j.contact[0];
    };
    double turned = 0;
    Complex before = F(0);
    constexpr double first = 1e-8;  // of the end
    for (int i = 0; i <= steps; ++i) {
        const Complex here = F(end * std::pow(first, 1 - double(i) / steps));
        turned += std::arg(here / before);
        before = here;
    }
    int poles = 0;
    for (int k = 0; k < j.friction[0].states; ++k) poles += j.friction[0].lambda[k] > sigma;
    return static_cast<int>(std::lround(1 - turned / std::numbers::pi)) + poles;
}

}  // namespace

TEST_CASE("W1: a critical gain is one that a user can turn to, where the velocity follows k_p")
{
    const auto ramp = found("w1-ramp");
    const auto verdict = linear_verdict(ramp).state_variable;
    REQUIRE(verdict.crossings.size() == 2);
    CHECK(verdict.crossings[0].k_p == Approx(2027.3848).epsilon(1e-7));
    CHECK(verdict.crossings[1].k_p == Approx(87596.64).epsilon(1e-7));
    CHECK(std::isnan(verdict.k_cr));
    check_gains(ramp, 2e2, 2e8);
    const auto margins = linear_study(ramp).margins;
    CHECK(margins.gain_below == Approx(87596.64 / 2e5).epsilon(1e-7));

    const auto one_speed = found("w1-one-speed");
    const auto other = linear_verdict(one_speed).state_variable;
    CHECK(other.k_cr == Approx(19.99e6).epsilon(1e-3));
    check_gains(one_speed, 2e2, 2e10);
}

TEST_CASE("W2: the spectral abscissa of kernels is that of a root, with none to its right", "[slow]")
{
    const auto [name, abscissa] = GENERATE(
        table<const char*, double>({{"w2-914", -22.3012131}, {"w2-993", -3.37138869}, {"w2-1693", -3.61550282}}));
    CAPTURE(name);
    const auto joint = found(name);
    const auto verdict = linear_verdict(joint).state_variable;
    CHECK(verdict.spectral_abscissa == Approx(abscissa).epsilon(1e-7));
    REQUIRE(!verdict.eigenvalues.empty());
    CHECK(verdict.eigenvalues[0].real() == verdict.spectral_abscissa);
    const auto linear = linear_joint(joint, joint.control.V0);
    const double aside = 1e-4 * std::abs(abscissa);
    CHECK(brute_count(linear, verdict.spectral_abscissa + aside, 3e5, 1'000'000) == 0);
    CHECK(brute_count(linear, verdict.spectral_abscissa - aside, 3e5, 1'000'000) > 0);
}

TEST_CASE("W3: verdict and stable gains never contradict each other")
{
    const auto joint = found("w3-345");
    const auto verdict = linear_verdict(joint).state_variable;
    CHECK(verdict.stable);
    CHECK(verdict.crossings.empty());
    REQUIRE(verdict.stable_intervals.size() == 1);
    check_gains(joint, 1e2, 1e7);

    const auto delayed = found("w3-553");
    const auto other = linear_verdict(delayed).state_variable;
    CHECK(other.stable);
    CHECK(holds(other.stable_intervals, delayed.control.k_p));
    check_gains(delayed, 1e4, 1e8);
}

TEST_CASE("W4: stiff springs beside a delay have a verdict")
{
    const auto verdict = linear_verdict(found("w4"));
    REQUIRE(verdict.steady.reason == Reason::none);
    CHECK_FALSE(verdict.state_variable.stable);
    int right = 0;
    for (const auto& s : verdict.state_variable.eigenvalues) right += s.real() > 0;
    CHECK(right == 8);
}

TEST_CASE("W6: velocities are searched on the side to which the joint moves")
{
    const auto joint = found("w6");
    const auto study = linear_study(joint);
    CHECK(study.state_variable.all_above == Approx(-11.4094606e-3).epsilon(1e-6));
    // and below 62.5 µm/s, where (22) falls less than the viscous part of 5 N·s/m rises: c3²/(2 c2) · 5
    REQUIRE(study.state_variable.intervals.size() == 2);
    CHECK(study.state_variable.intervals[0].high == study.state_variable.all_above);
    CHECK(study.state_variable.intervals[1].low == Approx(-62.5e-6).epsilon(1e-3));
    REQUIRE(study.range_gain);
    CHECK(study.range_gain->k_v == Approx(166.55).epsilon(1e-4));
    CHECK(study.range_gain->velocity < 0);
}

TEST_CASE("W8: the list of late eigenvalues begins with the root that makes the abscissa")
{
    const auto verdict = linear_verdict(found("w8")).state_variable;
    REQUIRE(!verdict.eigenvalues.empty());
    CHECK(verdict.eigenvalues[0].real() == verdict.spectral_abscissa);
    CHECK(verdict.spectral_abscissa == Approx(75.64).epsilon(1e-4));
}

TEST_CASE("W10: gains and lengths far outside any machine are answered by the closed form")
{
    auto joint = found("w7");
    auto& law = std::get<Ageing>(joint.friction.law);
    joint.control.k_p = 1e300;
    const auto stiff = linear_verdict(joint).state_variable;
    CHECK(stiff.stable);
    CHECK(stiff.spectral_abscissa == Approx(-100));  // −V_0/L of the contact, where the spring holds the mass
    CHECK(holds(stiff.stable_intervals, 1e300));
    joint.control.k_p = 6e4;
    const double m = 1, V0 = 1e-3, A = 1, B = 1.5, L = 1e-20, C = A / V0;
    law.L[0] = L;
    CHECK(linear_verdict(joint).state_variable.k_cr == Approx((B - A) / L * (1 + m * V0 / (L * C))).epsilon(1e-9));
}

// A motor behind a gear of 86:1: doublings of an exponential in double precision left three digits of a slow mode. The
// number is that of mpmath with 50 digits, by tests/reliability/loops.py.
TEST_CASE("growth of a stiff sampled loop", "[found]")
{
    CHECK(growth_rate(found("sampled-stiff-motor")) == Approx(-0.7360075760390392).epsilon(1e-6));
}

// QZ did not settle on the zeros of a loop with seven ticks of dead time, and its windows were "every gain".
TEST_CASE("windows of a sampled loop whose zeros are hard to find", "[found]")
{
    const auto joint = found("sampled-seven-ticks");
    check_gains(joint, 1e2, 1e7);
    CHECK(linear_verdict(joint).state_variable.stable_intervals.size() == 1);
}
