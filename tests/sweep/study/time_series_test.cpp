#include "sweep/study/time_series.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("samples are means of the straight lines, the last value behind them", "[study]")
{
    const TimeSeries s{{3, 4, 6}, {0, 2, -2}};
    // ∫ from the first row: t² up to 1, then 1 + 2(t − 1) − (t − 1)² up to 3, then −2 a second
    const auto means = s.sampled(0.8, 5);
    const auto integral = [](double t) {
        return t <= 1 ? t * t : t <= 3 ? 1 + 2 * (t - 1) - (t - 1) * (t - 1) : 1 - 2 * (t - 3);
    };
    for (int k = 0; k < 5; ++k)
        CHECK(means[k] == Approx((integral(0.8 * (k + 1)) - integral(0.8 * k)) / 0.8).margin(1e-12));
}
