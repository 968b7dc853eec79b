// Sets of gains in words.
#include "sweep/report/line_figure.h"

#include "analysis/results/text.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("sets of gains read as words, without infinities", "[report]")
{
    const auto text = [](std::vector<Interval> list) {
        return intervals_text(list, Quantity::stiffness, Motion::prismatic);
    };
    CHECK(text({}) == "none");
    CHECK(text({{0, infinity}}) == "all values");
    CHECK(text({{53.85e3, infinity}}) == "above 53.85 kN/m");
    CHECK(text({{0, 2e3}, {5e3, 8e3}}) == "below 2 kN/m, from 5 kN/m to 8 kN/m");
}
