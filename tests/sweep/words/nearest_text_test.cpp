#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/boundary/kinds/nearest.h"
#include "sweep/words/nearest_text.h"

using namespace stickslip;

TEST_CASE("a tolerance of all numbers at once is the distance that they reach together", "[report]")
{
    // a change of 20 % of the first and of 10 % of the others counts as one: all 30 % less, this far
    const std::vector<Coordinate> coordinates{{"a", "", 0.2}, {"b", "", 0.1}, {"c", "", 0.1}};
    double squares = 0;
    for (const auto& c : coordinates) squares += std::pow(std::log(0.7) / c.scale, 2);
    CHECK(off_text(tolerance_each(std::sqrt(squares), coordinates)) == "±30\u00a0%");
    CHECK(off_text(tolerance_each(std::log(1.25), {{"a", "", 1}})) == "±20\u00a0%");  // 1/1.25 = 0.8
}
