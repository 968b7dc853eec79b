#include <catch2/catch.hpp>
#include <cmath>

#include "sweep/words/nearest_text.h"

using namespace stickslip;

TEST_CASE("a tolerance of all numbers at once is the distance that they reach together", "[report]")
{
    // a change of 20 % of the first and of 10 % of the others counts as one: all 30 % less, this far
    const std::vector<double> scales{0.2, 0.1, 0.1};
    double squares = 0;
    for (const double scale : scales) squares += std::pow(std::log(0.7) / scale, 2);
    CHECK(all_at_once(std::sqrt(squares), scales) == "±30\u00a0%");
    CHECK(all_at_once(std::log(1.25), {1}) == "±20\u00a0%");  // 1/1.25 = 0.8
}
