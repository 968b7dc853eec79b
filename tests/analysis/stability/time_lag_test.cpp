// Friction with a time lag: windows of stable gains, without end.
#include <catch2/catch.hpp>

#include "analysis/stability/frequency_search.h"
#include "analysis/stability/winding.h"

using namespace stickslip;

namespace {

/// m = 1 kg, slope −100 N·s/m behind a lag: G(s) = 100 e^{−sτ}, f_v = 0
LinearJoint lagging(double lag, double k_v, double k_p = 1)
{
    LinearJoint joint;
    joint.inertia[0] = 1;
    joint.actuated[0] = 1;
    joint.k_v = k_v;
    joint.k_p = k_p;
    joint.friction[0].delays.push_back({100, lag});
    return joint;
}

}  // namespace

TEST_CASE("crossings of a lagging joint are those of the closed form", "[stability]")
{
    // ωτ = 2πn ± arccos(k_v/|f'|), k_p = m ω² + ω |f'| sin ωτ
    for (const double k_v : {0.0, 50.0, 99.0}) {
        const double lag = 5e-3, limit = 2e7;
        std::vector<double> expected;
        for (int n = 0; n < 40; ++n)
            for (const int sign : {-1, 1}) {
                const double angle = 2 * M_PI * n + sign * std::acos(k_v / 100), omega = angle / lag;
                const double k_p = omega * omega + omega * 100 * std::sin(angle);
                if (angle > 0 && k_p > 0 && k_p <= limit) expected.push_back(k_p);
            }
        std::sort(expected.begin(), expected.end());
        const auto found = search_crossings(lagging(lag, k_v), limit);
        CAPTURE(k_v);
        CHECK(found.doubtful.empty());
        REQUIRE(found.crossings.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            CHECK(found.crossings[i].k_p == Approx(expected[i]).epsilon(1e-12));
    }
    CHECK(search_crossings(lagging(5e-3, 101), 1e7).crossings.empty());
}

TEST_CASE("the number of unstable roots changes by two at every crossing", "[stability]")
{
    const auto found = search_crossings(lagging(5e-3, 20), 2e7);
    REQUIRE(found.crossings.size() > 4);
    int unstable = *roots_right_of(lagging(5e-3, 20, 0.5 * found.crossings[0].k_p), 0);
    CHECK(unstable > 0);
    for (std::size_t i = 0; i + 1 < found.crossings.size(); ++i) {
        unstable += 2 * found.crossings[i].direction;
        const double between = std::sqrt(found.crossings[i].k_p * found.crossings[i + 1].k_p);
        CHECK(*roots_right_of(lagging(5e-3, 20, between), 0) == unstable);
    }
}
