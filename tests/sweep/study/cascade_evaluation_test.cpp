// A cascade behind a filtered velocity is no sum of gains: whatever evaluate says is about the cascade.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/sum_of_gains.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/evaluation.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace stickslip;

namespace {

Joint cascade()
{
    Joint joint = example_joint(0, 0, 1e-3);
    auto& c = joint.control;
    c.structure = Structure::cascade;
    c.position_gain = 50, c.velocity_gain = 1200, c.velocity_integral_gain = 6e4;
    c.period = 5e-4;
    c.velocity_estimate.form = EstimateForm::backward_difference;
    c.velocity_estimate.tau = 5e-3;
    return joint;
}

JointEvaluation evaluated(const Joint& joint)
{
    EvaluationQuestion question;
    question.joint = joint;
    question.nonlinear.region = false;
    return evaluate_joint(question, [](EvaluationStage) {});
}

double boundary(const Joint& joint, BoundaryKind kind, const Axis& along)
{
    BoundaryRequest request;
    request.kind = kind;
    const auto ray = locate_boundaries(joint, along, request);
    REQUIRE(ray.points.size() == 1);
    return ray.points[0].value;
}

}  // namespace

TEST_CASE("an evaluation of a filtered cascade says of its loop what its boundaries say", "[evaluation]")
{
    const Joint joint = cascade();
    REQUIRE_FALSE(is_sum_of_gains(joint.control));
    const auto e = evaluated(joint);
    REQUIRE(e.study);
    CHECK(e.study->margins.phase * 180 / std::numbers::pi == Approx(e.verdict.state_variable.phase_margin_deg));
    // the dead time that the phase margin leaves is where the boundary along the dead time lies
    const double delay = boundary(joint, BoundaryKind::state_variable, axis("control.delay", 1e-3, 1e-2, true));
    CHECK(e.study->margins.phase / e.study->margins.crossover == Approx(delay).epsilon(0.02));
    const double slowest = boundary(joint, BoundaryKind::v_min, axis("control.V0", 1e-6, 1e-1, true));
    CHECK(std::abs(e.study->state_variable.all_above) == Approx(slowest).epsilon(1e-6));
    // what turns k_v has no answer of a cascade
    CHECK_FALSE(e.study->range_gain);
    CHECK_FALSE(e.study->comparison.known);
}

TEST_CASE("what an integral costs a cascade is counted in the gain of its position loop", "[evaluation]")
{
    const Joint joint = cascade();
    const auto e = evaluated(joint);
    REQUIRE(e.integral);
    const auto ends = [](const Joint& j) {
        BoundaryRequest request;
        const auto ray = locate_boundaries(j, axis("control.position_gain", 1e-3, 1e5, true), request);
        double nearest = infinity;
        for (const auto& p : ray.points) {
            const double own = j.control.position_gain;
            nearest = std::min(nearest, std::max(p.value / own, own / p.value));
        }
        return nearest - 1;
    };
    Joint without = joint;
    without.control.velocity_integral_gain = not_set;
    CHECK(e.integral->with == Approx(ends(joint)).epsilon(1e-6));
    CHECK(e.integral->without == Approx(ends(without)).epsilon(1e-6));
}

TEST_CASE("a cascade that is its sum of gains is evaluated as that", "[evaluation]")
{
    Joint joint = cascade();
    joint.control.velocity_estimate.tau = 0;
    REQUIRE(is_sum_of_gains(joint.control));
    const auto e = evaluated(joint);
    CHECK(e.study->range_gain);
    CHECK(e.study->margins.phase == Approx(evaluated(with_gains(joint)).study->margins.phase));
}
