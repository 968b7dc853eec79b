// Boundaries of loops that are so costly to solve that counts of roots tell their sides.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/kinds/linear_side.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/friction/time_lag.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

/// m = 1 kg under a friction of 2 kN·s/m that is late by τ: without a loop it sways from τ = π m/(2 c) on. Ticks of 30
/// ms make a place of the loop cost a hundred times as much as one of a loop that delays nothing.
Joint late_friction(double period)
{
    Joint joint = example_joint(1e3, 30, 2e-3);
    joint.mechanism.inertia = 1;
    TimeLag law;
    law.lag = 2e-4;
    law.curve.law = CoulombViscous{20, 2000};
    joint.friction.law = law;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.control.period = period;
    return joint;
}

/// The boundary over the lag lies where growth rates put it, whichever way its sides are found.
void lies_where_growth_changes_sign(const Joint& joint)
{
    CHECK(linear_region(joint) == linear_point(joint).region);
    BoundaryRequest request;
    request.kind = BoundaryKind::state_variable;
    request.scan = 8;
    const auto ray = locate_boundaries(joint, axis("friction.lag", 4e-4, 1.6e-3), request);
    const auto grown = locate_on_ray(joint, "friction.lag", 4e-4, 1.6e-3, true, Curve::Kind::state_variable, 8);
    REQUIRE(ray.points.size() == 1);
    REQUIRE(grown.size() == 1);
    CHECK(ray.points[0].value == Approx(grown[0].value).epsilon(1e-9));
    CHECK(ray.points[0].converged == grown[0].converged);
    CHECK(ray.points[0].value == Approx(M_PI / 2 / 2000).epsilon(0.02));
}

}  // namespace

TEST_CASE("a boundary of a loop with short ticks lies where growth rates put it", "[boundary][slow]")
{
    const Joint short_ticks = late_friction(2e-3), long_ticks = late_friction(3e-2);
    CHECK_FALSE(is_told_by_count(short_ticks, BoundaryKind::state_variable));
    CHECK(is_told_by_count(long_ticks, BoundaryKind::state_variable));
    lies_where_growth_changes_sign(short_ticks);
}

TEST_CASE("boundaries whose sides counts of roots tell lie where growth rates put them", "[boundary][slow]")
{
    lies_where_growth_changes_sign(late_friction(3e-2));
}
