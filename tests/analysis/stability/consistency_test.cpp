// The linear answers about one joint never contradict each other: verdict, abscissa, eigenvalues, stable gains, rows of
// a sweep, growth rate, and counts by the argument principle. Millions more: tests/reliability/consistency.cpp.
#include "tests/analysis/stability/random_joint.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("linear answers about random joints of every law, model and control agree", "[stability][slow]")
{
    constexpr std::uint64_t joints = 150;
    for (std::uint64_t number = 0; number < joints; ++number) {
        CAPTURE(number);
        CHECK(samples::contradiction(samples::random_joint(number)) == "");
    }
}

// A curve that is flat around the joint's own velocity, real roots at next to nothing, an eigenvalue that the motion
// does not notice, a velocity gain of 0 beside dead time, roots between poles that are no roots; slow roots from whose
// slopes the first step of a count saw nothing, fast roots of a delay that a scan over gains found at one of two,
// a friction state that the motion hardly notices; slow roots of a mass that only delayed friction damps; growth beyond
// all numbers within a tick, and growth that leaves no digit of what delayed friction takes off it.
TEST_CASE("linear answers about joints that once contradicted themselves agree", "[stability][slow]")
{
    for (const std::uint64_t number :
         {374, 431, 601, 811, 1182, 2351, 2652, 2843, 2859, 3051, 7192, 10354, 200021, 2234, 8538, 1796, 3738}) {
        CAPTURE(number);
        CHECK(samples::contradiction(samples::random_joint(number)) == "");
    }
}
