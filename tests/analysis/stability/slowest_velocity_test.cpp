// The slower a joint slides, the less its inertia counts, and in units of L/V_0 it is the same joint at every velocity
// that has a number.
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

constexpr double A = 1, B = 1.5, L = 1e-5, k_cr = (B - A) / L;  // of example_joint

}  // namespace

TEST_CASE("A joint at the slowest velocities is judged as at slow ones", "[stability]")
{
    // A z² + (k_p L − (B − A)) z + k_p L = 0, z = s L/V_0
    for (const double V0 : {1e-30, 1e-100, 1e-150, 1e-200, 1e-250, 1e-300})
        for (const double share : {0.9, 1.1}) {
            CAPTURE(V0, share);
            const auto verdict = linear_verdict(example_joint(share * k_cr, 0, V0));
            const auto& memory = verdict.state_variable;
            REQUIRE(verdict.steady.reason == Reason::none);
            CHECK(memory.stable == (share > 1));
            CHECK(!memory.neutral);
            CHECK(memory.k_cr == Approx(k_cr));
            CHECK(memory.spectral_abscissa * (L / V0) == Approx(-(share - 1) * (B - A) / (2 * A)));
            REQUIRE(memory.crossings.size() == 1);
            CHECK(memory.crossings[0].omega * (L / V0) == Approx(std::sqrt((B - A) / A)));
            REQUIRE(memory.stable_intervals.size() == 1);
            CHECK(memory.stable_intervals[0].low == Approx(k_cr));
            CHECK(linear_point(example_joint(share * k_cr, 0, V0)).k_cr == Approx(k_cr));
        }
}
