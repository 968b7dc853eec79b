// What a search for boundaries did not see is said with where it did not.
#include "sweep/words/boundary_text.h"
#include "analysis/boundary/kinds/outside.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Contains;

namespace {

Axis resistances(double low, double high)
{
    Axis axis{"actuator.resistance", "R", "resistance", Quantity::resistance, true, {low, high}};
    return axis;
}

/// Above about 3.1 Ω its supply no longer brings the effort up.
Joint weak_motor()
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute, joint.mechanism.inertia = 1;
    joint.control.k_p = 600, joint.control.k_v = 0.2, joint.control.V0 = 0.2;
    joint.friction.law = CoulombViscous{15, 1};
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor, a.k_t = a.k_e = 2, a.resistance = 1.5, a.supply_voltage = 24;
    return joint;
}

}  // namespace

TEST_CASE("A ray and what lies outside it count the points without a verdict and say where they lie", "[boundary]")
{
    const Joint joint = weak_motor();
    BoundaryRequest request;
    auto ray = locate_boundaries(joint, resistances(0.5, 2), request);
    REQUIRE(ray.points.empty());
    CHECK(ray.undecided == 0);
    CHECK(ray.without_verdict.empty());
    ray.outside = nearest_outside(joint, ray, request);
    const auto& outside = *ray.outside;
    REQUIRE_FALSE(outside.nearest);
    REQUIRE(outside.without_verdict.size() == 1);
    // F R/k_t + k_e V_0 = U at 15.2 N·m
    const double last = (24 - 2 * 0.2) * 2 / (15 + 0.2);
    const auto stretch = outside.without_verdict.front();
    CHECK(stretch.low > last);
    CHECK(stretch.low < 1.2 * last);
    CHECK(stretch.high == Approx(outside.high));
    CHECK(outside.undecided > 0);
    CHECK(outside.undecided < outside.nodes);
    const auto text = ray_text(joint, ray, {});
    CHECK_THAT(text, !Contains("either") && Contains("none was found at the points that have a verdict; " +
                                                     std::to_string(outside.undecided) + " of " +
                                                     std::to_string(outside.nodes) + " have none: from 3."));
    CHECK_THAT(could_be_missed(ray), Contains(" points outside have no verdict"));

    const auto wide = locate_boundaries(joint, resistances(0.5, 50), request);
    REQUIRE(wide.without_verdict.size() == 1);
    CHECK(wide.without_verdict.front().high == Approx(50));
    CHECK_THAT(ray_text(joint, wide, {}), Contains(" have none: from 3.") && Contains(" to 50 Ω"));
}

TEST_CASE("Nothing is said of what lies outside where no point there has a verdict", "[boundary]")
{
    Joint joint = weak_motor();
    LocatedRay ray;
    ray.axis = resistances(0.5, 2), ray.nodes = 200, ray.stable_share = 1;
    ray.outside = OutsideOfRay{};
    auto& outside = *ray.outside;
    outside.low = 0.1, outside.high = 20, outside.nodes = 400;
    CHECK_THAT(ray_text(joint, ray, {}), Contains("None was found within") && Contains("either"));
    outside.undecided = 400, outside.without_verdict = {{0.1, 0.5}, {2, 20}};
    CHECK_THAT(ray_text(joint, ray, {}), Contains("no point has a verdict") && !Contains("found"));
    outside.undecided = 3, outside.without_verdict = {{3, 3}, {5, 7}};
    outside.nearest = BoundaryPoint{};
    outside.nearest->value = 9;
    CHECK_THAT(ray_text(joint, ray, {}), Contains("The nearest one found outside lies at R = 9 Ω") &&
                                             Contains("3 of 400 have none: at 3 Ω, from 5 Ω to 7 Ω"));
}
