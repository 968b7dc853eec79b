// Sampled curves.
#include "sweep/study/samples.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;

TEST_CASE("a smoothed line has samples where it is steep and where it ends", "[study]")
{
    // ln y falls by 100 from 1 to e, where it ends; before and behind it is flat
    const auto y = [](double x) { return x < 1 ? 1 : x > std::exp(1.0) ? std::nan("") : std::exp(-100 * std::log(x)); };
    Samples line;
    for (int i = -4; i <= 8; ++i) line.x.push_back(std::exp(0.5 * i)), line.y.push_back(y(line.x.back()));
    smooth(line, y, 1, 8);
    REQUIRE(std::is_sorted(line.x.begin(), line.x.end()));
    for (std::size_t i = 1; i < line.x.size(); ++i) {
        CHECK((std::isnan(line.y[i]) || line.y[i] == y(line.x[i])));
        if (line.y[i] > 0 && line.y[i - 1] > 0) CHECK(std::abs(std::log(line.y[i] / line.y[i - 1])) <= 1);
        if (std::isnan(line.y[i]) && !std::isnan(line.y[i - 1])) CHECK(std::log(line.x[i] / line.x[i - 1]) < 0.01);
    }
    CHECK(line.x.size() < 180);  // the flat parts are left as they were
}
