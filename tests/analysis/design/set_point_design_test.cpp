// Designs of a set point: against their own windows, and against joints that are asked one by one.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "analysis/design/set_point_design.h"
#include "analysis/simulation/set_point/set_point.h"

using namespace stickslip;

namespace {

Joint arm()
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute;
    joint.mechanism.inertia = 0.3;
    joint.control.V0 = 0;
    joint.control.k_p = 450;
    joint.control.k_v = 5;
    joint.control.k_i = 900;
    joint.friction.law = KineticStatic{0.5, 3.3};
    return joint;
}

void one_by_one(std::size_t n, const std::function<void(std::size_t)>& task)
{
    for (std::size_t i = 0; i < n; ++i) task(i);
}

SetPointDesign designed(const Joint& joint, double margin, bool by_zone, bool by_push)
{
    SetPointRequirements r;
    r.friction_margin = margin;
    r.starts_per_decade = 8;
    r.over_dead_zone = by_zone, r.over_push = by_push;
    return design_set_point(joint, r, one_by_one);
}

const SetPointChoice& of(const SetPointDesign& design, SetPointWay way)
{
    for (const auto& c : design.choices)
        if (c.way == way) return c;
    throw std::logic_error("no such way");
}

}  // namespace

TEST_CASE("a design of a set point: windows in closed form, no friction within the margin hunts", "[design][set-point]")
{
    const double margin = 0.05;
    const auto design = designed(arm(), margin, false, true);
    CHECK(design.k_i_limit == Approx(450 * 5 / 0.3));
    CHECK_FALSE(of(design, SetPointWay::as_described).holds);
    const auto& free = of(design, SetPointWay::no_integral);
    CHECK(free.rest_error == Approx(3.3 * (1 + margin) / 450));
    const auto& push = of(design, SetPointWay::push);
    CHECK(push.low == Approx(3.3 * (1 + margin) - 0.5 * (1 - margin)));
    CHECK(push.high == Approx(3.3 * (1 - margin)));
    REQUIRE(push.holds);
    CHECK(push.rest_error == 0);
    const auto& alone = of(design, SetPointWay::push_without_integral);
    CHECK(alone.rest_error == Approx((3.3 * (1 + margin) - alone.push) / 450));
    REQUIRE(design.best >= 0);
    CHECK(design.choices[static_cast<std::size_t>(design.best)].way == SetPointWay::push);
    for (const auto& p : push.proofs) CHECK(p.answer.largest_ratio < 1);
}

TEST_CASE("the least dead zone of a design lies where hunting begins", "[design][set-point][slow]")
{
    const auto design = designed(arm(), 0, true, false);
    const auto& zone = of(design, SetPointWay::dead_zone);
    REQUIRE(zone.holds);
    Joint joint = arm();
    joint.control.dead_zone = 0.99 * zone.low;
    CHECK(set_point(joint).hunting == Hunting::yes);
    joint.control.dead_zone = 1.01 * zone.low;
    CHECK(set_point(joint).hunting == Hunting::no);
    CHECK(zone.dead_zone > zone.low);
    CHECK(zone.rest_error == Approx(zone.dead_zone));
}

TEST_CASE("where the drop may exceed the static friction no push holds", "[design][set-point]")
{
    const auto design = designed(arm(), 0.1, false, true);  // 3.63 − 0.45 above 2.97
    const auto& push = of(design, SetPointWay::push);
    CHECK_FALSE(push.holds);
    CHECK(push.low == Approx(3.18));
    CHECK(push.high == Approx(2.97));
}

TEST_CASE("a design of a set point recommends no gains with which the joint's own loop is unstable",
          "[design][set-point][slow]")
{
    // 100 Hz and a tick of dead time: a loop of 450 N·m/rad on 0.3 kg·m² turns by 39 rad/s, and lags 45° by then
    auto joint = arm();
    joint.control.period = 0.01, joint.control.delay = 0.01;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    auto design = designed(joint, 0.1, true, true);
    CHECK(design.k_i_limit == 0);
    CHECK(design.best == -1);
    for (const auto& c : design.choices)
        for (const auto& p : c.proofs) CHECK(p.answer.diverges());
    // softer it is stable up to a k_i, and everything recommended is below it
    joint.control.k_p = 60, joint.control.k_i = 0;
    SetPointRequirements r;
    r.starts_per_decade = 4;
    r.over_dead_zone = r.over_push = false;
    design = design_set_point(joint, r, one_by_one);
    CHECK(design.k_i_assumed);
    CHECK(design.k_i_limit > 0);
    CHECK(design.k_i_limit < 60 * 5 / 0.3);
    CHECK(design.k_i_used == Approx(0.1 * design.k_i_limit));
    joint.control.k_i = 0.98 * design.k_i_limit;
    CHECK_FALSE(set_point(joint).diverges());
    joint.control.k_i = 1.02 * design.k_i_limit;
    CHECK(set_point(joint).diverges());
}

TEST_CASE("a load counts once in the error of a way without an integral", "[design][set-point]")
{
    auto joint = arm();
    joint.load.constant = 2;
    const auto& free = of(designed(joint, 0, false, false), SetPointWay::no_integral);
    CHECK(free.rest_error == Approx((3.3 + 2) / 450));
}

TEST_CASE("a design of a set point says what it does not do", "[design][set-point]")
{
    auto joint = arm();
    joint.control.kind = ControlKind::force;
    CHECK_THROWS_AS(designed(joint, 0.1, true, true), std::invalid_argument);
    joint = arm();
    joint.friction.law = LuGre{1e5, 300, 0.4, 1, 1.5, 1e-3};
    CHECK_THROWS_AS(designed(joint, 0.1, true, true), std::invalid_argument);
}
