// Changes of side that values without a verdict hide, on sides written down here.
#include <catch2/catch.hpp>

#include "analysis/boundary/kinds/undecided_gap.h"

#include <cmath>

using namespace stickslip;

namespace {

constexpr double fine = 1e-4;
double width(double value)
{
    return fine * value;
}

}  // namespace

TEST_CASE("undecided gap: what has no verdict is closed in on from both ends", "[boundary]")
{
    const auto side = [](double x) { return x < 2.3 ? -1.0 : x > 2.33 ? 1.0 : missing; };
    const auto gap = closed_in(side, {2, 3}, -1, width);
    CHECK(gap.low < 2.3);
    CHECK(gap.low > 2.3 - 0.004);
    CHECK(gap.high > 2.33);
    CHECK(gap.high < 2.33 + 0.004);
    CHECK(gap.open_low >= 2.3);
    CHECK(gap.open_high <= 2.33);
    CHECK(gap.open_low - gap.low <= 0.1 * (gap.open_high - gap.open_low));
    CHECK(gap.high - gap.open_high <= 0.1 * (gap.open_high - gap.open_low));
    CHECK(gap.evaluations < 30);
}

TEST_CASE("undecided gap: a change beside values without a verdict is located", "[boundary]")
{
    // first probe 2.5 has none; the change lies at e
    const auto side = [](double x) { return std::abs(x - 2.5) < 0.01 ? missing : x < 2.718281828 ? 1.0 : -1.0; };
    const auto gap = closed_in(side, {2, 3}, 1, width);
    CHECK(std::isnan(gap.open_low));
    CHECK(gap.low <= 2.718281828);
    CHECK(gap.high >= 2.718281828);
    CHECK(gap.high - gap.low <= width(gap.high));
}

TEST_CASE("undecided gap: ends apart without a verdict between them", "[boundary]")
{
    int asked = 0;
    const auto never = [&](double) { return ++asked, missing; };
    const auto gap = closed_in(never, {2, 3, 2.5, 2.5}, -1, width, 5);
    CHECK(asked == 5);
    CHECK(gap.low == 2);
    CHECK(gap.high == 3);
    CHECK(gap.open_low < 2.5);
    CHECK(gap.open_high > 2.5);
}
