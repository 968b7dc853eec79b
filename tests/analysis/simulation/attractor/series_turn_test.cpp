// Revolutions by Taylor series against CVODE: where the motion is after the same time, and where its neighbours are.
#include "analysis/simulation/attractor/series_turn.h"

#include "analysis/simulation/solvers/motion.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

FlowVector followed(const Flow& flow, const FlowVector& start, double time)
{
    SlidingMotion motion(flow, Solver::cvode, 1e-11);
    motion.start(start);
    REQUIRE(motion.advance(time, 1'000'000));
    return motion.state();
}

double apart(const Flow& flow, const FlowVector& a, const FlowVector& b)
{
    return (a - b).cwiseQuotient(flow.scale()).cwiseAbs().maxCoeff();
}

void compare(const Joint& joint, double size)
{
    const auto flow = sliding_flow(joint).flow;
    const FlowVector scale = flow.scale();
    FlowVector start = flow.steady();
    start[0] += size * scale[0];
    CAPTURE(joint.control.k_p, flow.states, size);
    const auto turn = series_revolution(flow, start, {});
    REQUIRE(turn);
    const double time = turn->path.period;
    CHECK(apart(flow, turn->end, followed(flow, start, time)) < 1e-7 * size);
    CHECK(std::abs(flow.speed_measure(turn->end)) < 1e-12);
    CHECK(turn->path.velocity_min < flow.V0);
    CHECK(turn->path.velocity_max > flow.V0);
    for (int j = 0; j < flow.size(); ++j) {
        const double h = 1e-4 * size * scale[j];
        FlowVector above = start, below = start;
        above[j] += h, below[j] -= h;
        const FlowVector column = (followed(flow, above, time) - followed(flow, below, time)) / (2 * h);
        const double length = apart(flow, column, FlowVector::Zero(flow.size()));
        CHECK(apart(flow, turn->displacement.col(j), column) < 1e-4 * length);
    }
}

Joint with_two_states(Joint joint)
{
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B.push_back(0.7);
    law.L.push_back(4e-5);
    return joint;
}

}  // namespace

TEST_CASE("a revolution by series ends where CVODE does, and displacements end where they do", "[nonlinear]")
{
    compare(example_joint(2.2e4, 46, 1e-2), 0.1);
    compare(example_joint(2.2e4, 46, 1e-2), 1);
    compare(example_joint(4e4, 10, 1e-3), 0.5);
    compare(with_two_states(example_joint(4e4, 46, 1e-2)), 0.5);
}

TEST_CASE("series leave to the steps what is not theirs", "[nonlinear]")
{
    const auto answers = [](const Joint& joint) {
        const auto flow = sliding_flow(joint).flow;
        FlowVector start = flow.steady();
        start[0] += flow.scale()[0];
        return series_revolution(flow, start, {}).has_value();
    };
    Joint joint = example_joint(2.2e4, 46, 1e-2);
    CHECK(answers(joint));
    joint.friction.asymmetry.viscous = 1;
    CHECK_FALSE(answers(joint));
    CHECK_FALSE(answers(stribeck_joint(1e4, 0, 1e-3)));
    CHECK_FALSE(answers(example_joint(5e3, 10, 1e-4)));  // nearly rests: stiff
}
