// Random real loops whose verbs once contradicted each other.
#include "tests/analysis/loop/random_loop.h"
#include "analysis/simulation/attractor/nonlinear.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("what does not reach the link in its first turns is no steady sliding of an unstable joint",
          "[loop][found][slow]")
{
    // two masses with delayed friction on the link: evaluate said "stable-sliding" beside a growth of 124 1/s
    const auto joint = samples::random_loop(33);
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.growth_rate > 100);
    CHECK(verdict.outcome != Outcome::stable_sliding);
}
