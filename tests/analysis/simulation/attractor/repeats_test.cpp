// What a motion is that there is no work left to watch.
#include "analysis/simulation/attractor/repeats.h"
#include "analysis/numerics/lasting.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace stickslip;

namespace {

/// One number a turn.
int nearly(const std::vector<double>& turns)
{
    const auto gap = [&](int i, int j) { return std::abs(turns[i] - turns[j]); };
    return turns_to_repeat_nearly(static_cast<int>(turns.size()), gap, 1);
}

std::vector<double> turns(int count, double (*size)(int))
{
    std::vector<double> all;
    for (int i = 0; i < count; ++i) all.push_back(size(i));
    return all;
}

/// Equidistributed, and no two alike.
double wild(int i)
{
    return std::fmod(i * 0.6180339887498949, 1.0);
}

}  // namespace

TEST_CASE("turns that come back within the noise of their steps repeat, those that creep or wander do not",
          "[nonlinear]")
{
    CHECK(nearly(turns(40, [](int i) { return 1 + 1e-6 * wild(i); })) == 1);
    CHECK(nearly(turns(40, [](int i) { return 1 + 0.1 * (i % 4) + 1e-6 * wild(i); })) == 4);
    CHECK(nearly(turns(40, [](int i) { return 1 + 5e-4 * i; })) == 0);
    CHECK(nearly(turns(40, [](int i) { return 1 + 0.1 * wild(i); })) == 0);
}

TEST_CASE("sizes that go on as they are last; those that drift, fade or are few are not known to", "[nonlinear]")
{
    CHECK(lasts(turns(40, [](int i) { return 1 + 0.1 * wild(i); })));
    CHECK_FALSE(lasts(turns(40, [](int i) { return 1 + 0.1 * wild(i) + 0.01 * i; })));
    CHECK_FALSE(lasts(turns(40, [](int i) { return 1 + 0.1 * wild(i) * std::exp(-0.1 * i); })));
    CHECK_FALSE(lasts(turns(10, [](int i) { return 1 + 0.1 * wild(i); })));
}
