// The period of a cycle in a sampled loop is that of whole turns, wherever the first one began.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/loop_record.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace stickslip;

namespace {

Joint sticking(double V0)
{
    Joint j;
    j.mechanism.motion = Motion::revolute;
    j.mechanism.inertia = 0.05;
    j.control.k_p = 60, j.control.k_v = 1, j.control.V0 = V0, j.control.period = 1e-3;
    j.control.velocity_estimate.form = EstimateForm::backward_difference;
    j.control.velocity_estimate.tau = 3e-3;
    j.friction.law = Stribeck{0.3, 0.02, 0.25, 0.05, 2};
    return j;
}

/// Of the motion along a ramp, by the times at which it passes the middle of its way about the ramp.
double period_along_ramp(const Joint& j, double duration)
{
    ReferenceMotion ramp;
    ramp.time = {0, duration};
    ramp.position = {0, j.control.V0 * duration};
    ramp.velocity = {j.control.V0, j.control.V0};
    const auto record = record_along(j, ramp, 0);
    std::vector<double> about;
    for (std::size_t k = record.time.size() / 2; k < record.time.size(); ++k)
        about.push_back(record.position[k] - record.reference_position[k]);
    const auto [low, high] = std::ranges::minmax(about);
    const double middle = 0.5 * (low + high);
    std::vector<double> passed;
    for (std::size_t k = 1; k < about.size(); ++k)
        if (about[k - 1] < middle && about[k] >= middle)
            passed.push_back(static_cast<double>(k - 1) + (middle - about[k - 1]) / (about[k] - about[k - 1]));
    REQUIRE(passed.size() > 10);
    return (passed.back() - passed.front()) / static_cast<double>(passed.size() - 1) * j.control.period;
}

}  // namespace

TEST_CASE("the period of stick-slip in a sampled loop is that of its motion, in either direction", "[loop][sampled]")
{
    for (const double lag : {0.0, 5e-3}) {
        Joint forwards = sticking(0.05), backwards = sticking(-0.05);
        forwards.actuator.lag = backwards.actuator.lag = lag;
        const double truth = period_along_ramp(forwards, 10);
        CAPTURE(lag);
        CHECK(nonlinear_verdict(forwards, {}).period == Approx(truth).epsilon(1e-4));
        CHECK(nonlinear_verdict(backwards, {}).period == Approx(truth).epsilon(1e-4));
    }
}

TEST_CASE("Slowed below where its limit holds friction a loop stops for good, so that steady sliding is not all",
          "[loop]")
{
    // 60 N at V_0, and 0.5 N more for each e-fold less: 60.5 N are passed at 0.37 V_0
    Joint joint = ticked_joint(70e3);
    joint.control.effort_limit = 60.5;
    const auto small = nonlinear_verdict(joint, {});
    CHECK(small.outcome == Outcome::stable_sliding);
    CHECK(small.region == NonlinearRegion::bistable);
    NonlinearOptions pushed;
    pushed.disturbance = {DisturbanceKind::offset, 1e-4};
    CHECK(nonlinear_verdict(joint, pushed).outcome == Outcome::held);
    pushed.disturbance.size = 3e-5;
    CHECK(nonlinear_verdict(joint, pushed).outcome == Outcome::stable_sliding);
    joint.control.effort_limit = 66;
    CHECK(nonlinear_verdict(joint, {}).region == NonlinearRegion::stable);
}
