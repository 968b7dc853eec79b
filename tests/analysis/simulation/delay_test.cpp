// Friction that answers late: the windows of stable gains and the growth between them, by simulation.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/nonlinear.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

/// A curve of slope −100 N·s/m at V_0 = 1 mm/s under 1 kg, 5 ms late.
Joint late_joint(double k_p, double k_v)
{
    Joint joint = stribeck_joint(k_p, k_v, 1e-3);
    Stribeck curve;
    curve.c0 = 8, curve.c1 = 0, curve.c2 = 0.5, curve.c3 = 2e-3;
    // −f_ss'(V_0) = 2 c2 V_0/c3² exp(−(V_0/c3)²), scaled to 100
    curve.c2 *= 100 / (2 * curve.c2 * 1e-3 / 4e-6 * std::exp(-0.25));
    TimeLag law;
    law.lag = 5e-3;
    law.curve.law = curve;
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("time lag: windows of stable gains, by the method of steps", "[nonlinear]")
{
    // m = 1, |f'| = 100, τ = 5 ms, k_v = 0: stable for 130112 < k_p < 794017 N/m; k_v = 50: from 62003 on
    NonlinearOptions options;
    options.region = false;
    const auto outcome = [&](double k_p, double k_v) {
        return nonlinear_verdict(late_joint(k_p, k_v), options).outcome;
    };
    CHECK(outcome(0.95 * 130112, 0) != Outcome::stable_sliding);
    CHECK(outcome(1.05 * 130112, 0) == Outcome::stable_sliding);
    CHECK(outcome(0.97 * 794017, 0) == Outcome::stable_sliding);
    CHECK(outcome(1.03 * 794017, 0) != Outcome::stable_sliding);
    CHECK(outcome(0.95 * 62003, 50) != Outcome::stable_sliding);
    CHECK(outcome(1.05 * 62003, 50) == Outcome::stable_sliding);
}

TEST_CASE("time lag: the measured growth solves the characteristic equation", "[nonlinear]")
{
    // m s² + (k_v − |f'| e^{−sτ}) s + k_p = 0 for the pair near i √(k_p/m), by Newton
    for (const double k_p : {5e4, 2e5, 9e5}) {
        std::complex<double> s(0, std::sqrt(k_p));
        for (int i = 0; i < 50; ++i) {
            const auto late = 100.0 * std::exp(-s * 5e-3);
            s -= (s * s - late * s + k_p) / (2.0 * s - late + 5e-3 * late * s);
        }
        NonlinearOptions options;
        options.region = false;
        CAPTURE(k_p, s.imag());
        CHECK(nonlinear_verdict(late_joint(k_p, 0), options).growth_rate == Approx(s.real()).epsilon(2e-3));
    }
}
