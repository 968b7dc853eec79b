// Friction that falls so steeply that a small disturbance leaves steady sliding between two ticks.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/lanes/ticked_batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace stickslip;

namespace {

/// 1 kg at a period of 10 ms; the slope at V_0 is about −1.47 N per velocity.
Joint steep(double velocity)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    auto& c = joint.control;
    c.k_p = 1000, c.k_v = 10, c.V0 = velocity;
    c.period = 10e-3;
    c.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = Stribeck{4, 1, 2, velocity, 2};
    return joint;
}

/// Growth within a tick is that of the linear theory, alone and in a sweep.
void grows_as_linear(std::initializer_list<double> velocities)
{
    // measured over a tick it came out as 0.59 1/s beside a root of 14.7 × 10³ 1/s: friction had long come to rest
    for (const double velocity : velocities) {
        const std::array joints{steep(velocity)};
        const auto row = linear_point(joints[0]);
        INFO("V_0 " << velocity << ": " << row.spectral_abscissa << " 1/s");
        REQUIRE(row.spectral_abscissa > 1e3);
        const auto verdict = nonlinear_verdict(joints[0], {});
        CHECK(verdict.growth_rate == Approx(row.spectral_abscissa).epsilon(1e-7));
        CHECK(verdict.region == NonlinearRegion::stick_slip);
        std::array rows{row};
        nonlinear_points(joints, {}, rows);
        CHECK(rows[0].growth_rate == Approx(row.spectral_abscissa).epsilon(1e-7));
        CHECK(rows[0].outcome == verdict.outcome);
    }
}

}  // namespace

TEST_CASE("growth within a tick is that of the linear theory, alone and in a sweep", "[simulation][loop][steep]")
{
    grows_as_linear({1e-3, 1e-4});
}

TEST_CASE("growth within a tick is that of the linear theory when it is faster still",
          "[simulation][loop][steep][slow]")
{
    grows_as_linear({3e-5, 1e-5, 3e-6});
}
