// Disturbances of stated size next to the edge of the basin of steady sliding, decided by few of their turns.
#include <catch2/catch.hpp>

#include <cmath>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/flows/mode.h"
#include "analysis/simulation/lanes/basin.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/solvers/motion.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

constexpr double L = 1e-5;  // m, of example_joint

/// Above the critical gain by 0.2 %, so that small motions creep back.
Joint above_critical(double k_v)
{
    return example_joint(1.002 * linear_point(example_joint(1, k_v, 1e-2)).k_cr, k_v, 1e-2);
}

double side(const Joint& joint, double position)
{
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::position, position};
    options.region = false;
    double found = missing;
    lanes::sides({&joint, 1}, options, {&found, 1});
    return found;
}

/// Growth of the amplitude in the third turn, which lies on the slow manifold, by another method at 1e-12.
double growth_of_third_turn(const Joint& joint, double position)
{
    const auto flow = sliding_flow(joint).flow;
    const auto mode = slow_mode(flow);
    SlidingMotion motion(flow, Solver::rodas5p, 1e-12);
    motion.start(disturbed(flow, mode, DisturbanceKind::position, position));
    double amplitude[2] = {};
    for (int turn = 0; turn < 4; ++turn) {
        amplitude[0] = amplitude[1];
        const auto state = motion.turn(motion.time() + 1e6).state;
        amplitude[1] = std::abs(flow.position(state) - flow.position(mode.steady));
    }
    return std::log(amplitude[1] / amplitude[0]);
}

lanes::Answer answer(const Joint& joint, double position, bool side_only)
{
    const auto scaled = lanes::scaled(joint);
    auto job = lanes::job(scaled->groups, false);
    REQUIRE(lanes::state({DisturbanceKind::position, position}, joint, *scaled, job));
    job.side_only = side_only;
    lanes::Answer found;
    lanes::run(&job, &found, 1, {}, lanes::Instructions::baseline);
    return found;
}

}  // namespace

TEST_CASE("the edge of a basin is where a turn by another method grows", "[lanes]")
{
    // position in L; leaping outwards along the creeping motion used to misplace the edge by 0.1 % and more
    for (const double k_v : {44.0, 44.6}) {
        const Joint joint = with_ageing(above_critical(k_v));
        double inside = 0.3 * L, outside = 0.6 * L;
        for (int i = 0; i < 14; ++i) {
            const double middle = std::sqrt(inside * outside);
            (growth_of_third_turn(joint, middle) < 0 ? inside : outside) = middle;
        }
        CAPTURE(k_v, inside / L);
        CHECK(side(joint, 0.9994 * inside) == -1);
        CHECK(side(joint, 1.0006 * outside) == 1);
    }
}

TEST_CASE("few turns tell the side that all turns end on", "[lanes]")
{
    int decays = 0, leaves = 0;
    for (const double k_v : {44.0, 47.5, 49.1})
        for (const double position : {0.1, 0.3, 1.0, 3.0, 10.0}) {
            const Joint joint = above_critical(k_v);
            const auto few = answer(joint, position * L, true), all = answer(joint, position * L, false);
            CAPTURE(k_v, position, few.steps, all.steps);
            CHECK((few.ending == lanes::Ending::leaves || few.reached) == all.reached);
            if (few.ending == lanes::Ending::leaves) CHECK(few.steps < all.steps);
            ++(all.reached ? leaves : decays);
            CHECK(few.turns <= 20);
        }
    CHECK(decays > 2);
    CHECK(leaves > 2);
}

TEST_CASE("the bound of the return map's determinant holds for cycles", "[lanes]")
{
    for (const bool ages : {false, true})
        for (const double beta : {1.5, 5.0, 15.0}) {
            const double M = 10, c = 0.1;  // the stiffer, the shorter the period and the weaker the contraction
            Joint joint = dimensionless_joint(0.6 * (beta - 1 - c) * (1 + M / (1 + c)), M, beta, c);
            if (ages) joint = with_ageing(joint);
            const auto cycle = nonlinear_verdict(joint, {});
            CAPTURE(ages, beta, cycle.period);
            REQUIRE(cycle.multipliers.size() == 2);
            const double determinant = std::abs(cycle.multipliers[0] * cycle.multipliers[1]);
            const auto scaled = lanes::scaled(joint);
            const double period = cycle.period * scaled->velocity / scaled->length;
            CHECK(determinant <= lanes::largest_determinant(period, c, M) * (1 + 1e-6) + 1e-9);
        }
}
