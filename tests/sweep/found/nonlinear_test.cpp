// Nonlinear answers that were once wrong, found by independent code, each under the name with which it was reported.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/boundary/kinds/boundary.h"
#include "sweep/files/toml/joint_file.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

Joint found(const std::string& name)
{
    return read_joint("tests/sweep/found/" + name + ".toml");
}

double fold_of(Joint joint, double k_p)
{
    joint.control.k_p = k_p;
    NonlinearOptions options;
    options.bifurcation = true;
    return nonlinear_verdict(joint, options).fold_k_p;
}

}  // namespace

TEST_CASE("W5: the fold beyond a nearly degenerate Hopf point is found from either side of the critical gain")
{
    const auto joint = found("w5");
    // as located by `boundary --kind fold`, which follows the branch by its arc
    const double k_cr = 1557.8476520, fold = 5349.5566;
    for (const double factor : {0.99, 0.99995, 1.0001, 1.01, 2.2}) {
        CAPTURE(factor);
        CHECK(fold_of(joint, factor * k_cr) == Approx(fold).epsilon(1e-6));
    }
}

TEST_CASE("W5: the fold of a branch whose gain runs off within small amplitudes is found at every gain", "[slow]")
{
    const auto joint = found("w5-small-orbits");
    // as located by `boundary --kind fold`
    const double k_cr = 788.7785, fold = 7.047285 * k_cr;
    for (const double factor : {0.5, 0.99, 1.0001, 1.5}) {
        CAPTURE(factor);
        CHECK(fold_of(joint, factor * k_cr) == Approx(fold).epsilon(1e-5));
    }
}

TEST_CASE("W7: the fold close above a subcritical linear boundary is found on a wide axis, too")
{
    const auto joint = found("w7");
    BoundaryRequest request;
    request.kind = BoundaryKind::fold;
    Axis axis;
    axis.path = "control.k_p";
    axis.log = true;
    axis.values = {27.5e3, 825e3};
    const auto ray = locate_boundaries(joint, axis, request);
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value == Approx(1.00124419 * 55000).epsilon(1e-7));
}

TEST_CASE("W6: the least velocity lies on the side to which the joint moves")
{
    BoundaryRequest request;
    request.kind = BoundaryKind::v_min;
    Axis axis;
    axis.path = "control.V0";
    axis.values = {-0.1, -0.001};
    const auto ray = locate_boundaries(found("w6"), axis, request);
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value == Approx(-11.4094606e-3).epsilon(1e-7));
}

TEST_CASE("W11: undamped kinetic and static friction answers for the disturbance that is asked for")
{
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::start, 0};
    const auto verdict = nonlinear_verdict(found("w11"), options);
    CHECK(verdict.outcome == Outcome::stick_slip);
    // sticks until the spring has taken F_s, slips on m ẍ + k_p x = F_k: a = √((F_s − F_k)²/k_p² + m V_0²/k_p)
    CHECK(verdict.amplitude == Approx(1.048808848e-3).epsilon(1e-6));
    CHECK(verdict.period == Approx(0.3187165643).epsilon(1e-6));
    CHECK(verdict.velocity_max == Approx(43.166248e-3).epsilon(1e-6));
    options.disturbance = {};
    CHECK(nonlinear_verdict(found("w11"), options).reason == Reason::neutral);
}

// A limit of the effort is followed in fixed steps, in which an undamped oscillation grows by itself.
TEST_CASE("W11: the same with a limit that it does not reach, followed tick by tick")
{
    auto joint = found("w11");
    joint.control.effort_limit = 1e3;
    CHECK(nonlinear_verdict(joint, {}).reason == Reason::neutral);
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::start, 0};
    CHECK(nonlinear_verdict(joint, options).outcome == Outcome::stick_slip);
    options.disturbance = {DisturbanceKind::position, 1e-6};
    CHECK(nonlinear_verdict(joint, options).reason == Reason::neutral);
    joint.control.k_v = 1e-6;  // 1.6e-8 of |s|: damps
    const auto damped = nonlinear_verdict(joint, {});
    CHECK(damped.growth_rate == Approx(-0.5e-6));
    CHECK(damped.outcome == Outcome::stable_sliding);
    CHECK(damped.region == NonlinearRegion::bistable);
}

TEST_CASE("W9: every turn of a motion counts among those after which it repeats, however small", "[slow]")
{
    const auto verdict = nonlinear_verdict(found("w9"), {});
    CHECK(verdict.outcome == Outcome::period_n);
    CHECK(verdict.repeats == 13);  // largest positions per period, by an integration of its own
    CHECK(verdict.period == Approx(835.7777).epsilon(1e-6));
    CHECK(verdict.amplitude == Approx(161.183).epsilon(1e-5));
}

TEST_CASE("W12: what a motion comes to is judged within the work of one verdict, or what it takes is said", "[slow]")
{
    const auto with = [](const std::string& name, double effort) {
        NonlinearOptions options;
        options.effort = effort;
        return nonlinear_verdict(found(name), options);
    };
    const auto verdict = with("w12-stribeck", 1);
    CHECK(verdict.outcome == Outcome::irregular);
    CHECK(verdict.repeats == 1);
    CHECK(verdict.amplitude == Approx(0.28e-3).epsilon(0.1));
    const auto cut = with("w12-stribeck", 0.02);
    CHECK(cut.outcome == Outcome::undecided);
    CHECK(cut.reason == Reason::not_converged);
    CHECK(cut.detail == Detail::limit_of_work);
    CHECK(cut.region == NonlinearRegion::stick_slip);  // small disturbances grow all the same
    // a sampled loop, followed tick by tick
    auto sampled = found("w12-stribeck");
    sampled.control.period = 1e-4, sampled.control.velocity_estimate.form = EstimateForm::exact;
    NonlinearOptions options;
    CHECK(nonlinear_verdict(sampled, options).outcome != Outcome::undecided);
    options.effort = 1e-3;
    CHECK(nonlinear_verdict(sampled, options).detail == Detail::limit_of_work);
}
