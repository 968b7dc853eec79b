// A lag far shorter than the loop is followed as a dead time: in the steps of the loop, and with the loop's own growth.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("a lag far below the loop costs no steps and keeps the growth of the linear theory", "[sampled][lag][slow]")
{
    Joint joint = example_joint(45000, 10, 1e-3);
    const double usual = tick_of(joint);
    for (const double lag : {1e-8, 1e-7, 5e-7}) {
        joint.actuator.lag = lag;
        CHECK(tick_of(joint) == usual);
        CHECK(loop_verdict(joint, {}).growth_rate == Approx(growth_rate(joint)).epsilon(1e-3));
    }
    joint.actuator.lag = 0.1 * usual;  // not short: followed as a lag, in finer steps
    CHECK(tick_of(joint) < usual);
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::exact;
    CHECK(tick_of(joint) == 1e-3);
}
