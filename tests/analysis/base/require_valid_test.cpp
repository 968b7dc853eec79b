#include "analysis/base/require_valid.h"

#include "analysis/boundary/kinds/nearest.h"
#include "analysis/diagnosis/diagnose.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/simulation/simulate.h"
#include "tests/analysis/joint/sample_joints.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

/// `change` makes options of this kind wrong: they say so and name the number.
template <class Options, class Change>
void check_problem(Change change, const std::string& name)
{
    Options options;
    CHECK(options.problem().empty());
    change(options);
    CAPTURE(name);
    CHECK_THAT(options.problem(), Contains(name + ": got ") && Contains(", expected "));
    CHECK_THROWS_AS(require_valid(options), std::invalid_argument);
}

}  // namespace

TEST_CASE("options say what is wrong with them, with what they got and what they expect", "[options]")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    check_problem<NonlinearOptions>([&](auto& o) { o.rtol = 0; }, "rtol");
    check_problem<NonlinearOptions>([&](auto& o) { o.rtol = nan; }, "rtol");
    check_problem<NonlinearOptions>([&](auto& o) { o.turn_limit = 0; }, "turn_limit");
    check_problem<NonlinearOptions>([&](auto& o) { o.effort = inf; }, "effort");
    check_problem<NonlinearOptions>([&](auto& o) { o.disturbance.size = -inf; }, "disturbance.size");
    check_problem<SimulateOptions>([&](auto& o) { o.rtol = 0.1; }, "rtol");
    check_problem<SimulateOptions>([&](auto& o) { o.duration = 0; }, "duration");
    check_problem<SimulateOptions>([&](auto& o) { o.cycle_period = inf; }, "cycle_period");
    check_problem<SimulateOptions>([&](auto& o) { o.force.value = {1}; }, "force.step");
    check_problem<SimulateOptions>([&](auto& o) { o.normal_load.value = {1}; }, "normal_load.step");
    check_problem<NearestOptions>([&](auto& o) { o.reach = -1; }, "reach");
    check_problem<NearestOptions>([&](auto& o) { o.rays = 0; }, "rays");
    check_problem<NearestOptions>([&](auto& o) { o.local = -1; }, "local");
    check_problem<NearestOptions>([&](auto& o) { o.precision = 1; }, "precision");
    check_problem<BoundaryRequest>([&](auto& o) { o.precision = 0; }, "precision");
    check_problem<BoundaryRequest>([&](auto& o) { o.scan = -1; }, "scan");
    check_problem<BoundaryRequest>([&](auto& o) { o.following.guard = -1; }, "guard");
    check_problem<FollowingOptions>([&](auto& o) { o.shortest_step = 0; }, "shortest_step");
    check_problem<FollowingOptions>([&](auto& o) { o.longest_step = nan; }, "longest_step");
    check_problem<FollowingOptions>([&](auto& o) { o.turn = 0; }, "turn");
    check_problem<FollowingOptions>([&](auto& o) { o.point_limit = 0; }, "point_limit");
    check_problem<SetPointQuestion>([&](auto& o) { o.starts_per_decade = 0; }, "starts_per_decade");
    check_problem<gap::DiagnosisOptions>([&](auto& o) { o.ensemble = 1; }, "ensemble");
}

TEST_CASE("what is asked with wrong options is refused before anything is computed", "[options]")
{
    const Joint joint = samples::single_mass(1);
    NonlinearOptions nonlinear;
    nonlinear.rtol = -1;
    CHECK_THROWS_WITH(nonlinear_verdict(joint, nonlinear), "rtol: got -1, expected above 0 and at most 0.01");
    SimulateOptions simulation;
    simulation.duration = -1;
    CHECK_THROWS_AS(simulate(joint, simulation), std::invalid_argument);
    NearestOptions nearest;
    nearest.rays = 0;
    CHECK_THROWS_AS(nearest_boundary(joint, {}, nearest), std::invalid_argument);
    BoundaryRequest request;
    request.scan = -1;
    const Axis axis{"control.k_p", "k_{p}", "position gain", Quantity::stiffness, true, {1e3, 1e6}};
    CHECK_THROWS_AS(locate_boundaries(joint, axis, request), std::invalid_argument);
    CHECK_THROWS_AS(follow_boundaries(joint, axis, axis, request), std::invalid_argument);
    CHECK_THROWS_AS(set_point(joint, {.starts_per_decade = 0}), std::invalid_argument);
    CHECK_THROWS_AS(gap::diagnose(joint, {}, test::in_order, {.ensemble = 0}), std::invalid_argument);
}
