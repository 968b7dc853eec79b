// Lanes of two states and of bristles against CVODE at rtol 1e-11, and their promise of equal bits.
#include <catch2/catch.hpp>

#include "tests/analysis/simulation/lanes/lanes_comparison.h"
#include "tests/analysis/simulation/lanes/watched_answers.h"
#include "tests/analysis/simulation/lanes/watched_joints.h"

using namespace stickslip;

namespace {

/// Every row as CVODE has it; how many of them lanes decided.
int same_as_cvode(const std::vector<Joint>& joints)
{
    int by_lanes = 0;
    for (const auto& c : compare_with_cvode(joints, true)) {
        CHECK(c.same_outcome());
        // of what lanes leave over, CVODE at 1e-11 may run out of work where at the sweep's tolerance it does not
        if (c.row.path == DecisionPath::lanes) CHECK(c.row.reason == c.truth.reason);
        CHECK(c.row_spectrum < 1e-7);
        CHECK(c.rest < 1e-5);
        CHECK(c.period < 1e-5);
        CHECK(c.amplitude < 1e-4);
        by_lanes += c.row.path == DecisionPath::lanes;
    }
    return by_lanes;
}

}  // namespace

TEST_CASE("two states in lanes: every row as CVODE has it", "[lanes][slow]")
{
    CHECK(same_as_cvode(random_two_state_joints(60, 21)) > 55);
    auto ageing = random_two_state_joints(40, 27);
    for (auto& joint : ageing) joint = with_ageing(joint);
    CHECK(same_as_cvode(ageing) > 36);
}

TEST_CASE("bristles in lanes: every row as CVODE has it", "[lanes][slow]")
{
    CHECK(same_as_cvode(random_lugre_joints(60, 22)) > 55);
}

TEST_CASE("an answer of two states or bristles depends on its job alone", "[lanes]")
{
    auto jobs = jobs_of(random_two_state_joints(40, 23));
    for (const auto& job : jobs_of(random_lugre_joints(40, 24))) jobs.push_back(job);
    check_that_jobs_are_alone(jobs);
}

TEST_CASE("disturbances of stated size of two states and bristles end in lanes as CVODE has it", "[lanes][slow]")
{
    auto joints = random_two_state_joints(8, 25);
    for (const auto& joint : random_lugre_joints(8, 26)) joints.push_back(joint);
    StatedComparison compare;
    for (const auto& joint : joints) {
        const double V0 = joint.control.V0, m = joint.mechanism.inertia, time = std::sqrt(m / joint.control.k_p);
        compare(joint, {DisturbanceKind::position, 0.3 * V0 * time});
        compare(joint, {DisturbanceKind::velocity, 0.5 * V0});
        compare(joint, {DisturbanceKind::impulse, -0.4 * m * V0});
        compare(joint, {DisturbanceKind::offset, 2 * V0 * time});
        compare(joint, {DisturbanceKind::state, 0.2 * joint.control.k_p * V0 * time});
        compare(joint, {DisturbanceKind::start, 0.02});
    }
    CHECK(compare.by_lanes > 0.9 * compare.asked);
}
