// Springs that harden: their inverse, the slope that the linear theory takes, and the simulated growth beside it.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/joint/spring.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// By halving, of k x + k_3 x³ = F.
double stretch_by_halving(double k, double cubic, double effort)
{
    double low = 0, high = effort / k;
    for (int i = 0; i < 200; ++i) {
        const double x = (low + high) / 2;
        (k * x + cubic * x * x * x < effort ? low : high) = x;
    }
    return low;
}

}  // namespace

TEST_CASE("the stretch of a spring that hardens gives its effort", "[hardening]")
{
    for (const double cubic : {0.0, 1e-200, 1.0, 1e6, 1e14, 1e30})
        for (const double effort : {1e-12, 1e-3, 1.0, 40.0, 1e7}) {
            const Spring spring{2e4, cubic};
            CAPTURE(cubic, effort);
            CHECK(spring.stretch(effort) == Approx(stretch_by_halving(2e4, cubic, effort)).epsilon(1e-12));
            CHECK(spring.effort(spring.stretch(-effort)) == Approx(-effort).epsilon(1e-12));
        }
}

TEST_CASE("the linear theory has the slope of a hardening spring where friction and load stretch it", "[hardening]")
{
    for (const double V : {1e-3, -1e-3}) {
        Joint joint = samples::two_mass();
        joint.mechanism.transmission.stiffness = 3e4;
        joint.mechanism.transmission.cubic_stiffness = 3e4 / std::pow(2e-4, 2);
        joint.frictions.link.law = Stribeck{6, 20, 2, 2e-3, 2};
        joint.load.constant = -3;
        joint.control.V0 = V;
        const double carried = steady_force(joint.frictions.link, V) + 3;
        const double x = stretch_by_halving(3e4, joint.mechanism.transmission.cubic_stiffness, std::abs(carried));
        const double slope = 3e4 + 3 * joint.mechanism.transmission.cubic_stiffness * x * x;
        Joint stiff = joint;
        stiff.mechanism.transmission.stiffness = slope, stiff.mechanism.transmission.cubic_stiffness = 0;
        CHECK(slope > 1.2 * 3e4);
        CHECK(spectral_abscissa(linear_joint(joint, V)) ==
              Approx(spectral_abscissa(linear_joint(stiff, V))).epsilon(1e-10));
    }
}

TEST_CASE("a motion beside steady sliding grows as the slope of the spring says", "[hardening][slow]")
{
    Joint joint = samples::two_mass();
    joint.mechanism.transmission.stiffness = 3e4;
    joint.mechanism.transmission.cubic_stiffness = 3e4 / std::pow(2e-4, 2);
    joint.control.k_p = 4e3;
    NonlinearOptions options;
    options.region = false;
    const auto followed = nonlinear_verdict(joint, options);
    const double growth = spectral_abscissa(linear_joint(joint, joint.control.V0));
    Joint linear = joint;
    linear.mechanism.transmission.cubic_stiffness = 0;
    const double without = spectral_abscissa(linear_joint(linear, joint.control.V0));
    CHECK(std::abs(without / growth - 1) > 0.05);
    CHECK(followed.growth_rate == Approx(growth).epsilon(1e-2));
}
