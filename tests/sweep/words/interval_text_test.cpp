// Sets of gains in words.
#include "sweep/words/interval_text.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("sets of gains read as words, without infinities", "[report]")
{
    const auto text = [](std::vector<Interval> list) {
        return intervals_text(list, Quantity::stiffness, Units(Motion::prismatic));
    };
    CHECK(text({}) == "none");
    CHECK(text({{0, infinity}}) == "all values");
    CHECK(text({{53.85e3, infinity}}) == "above 53.85 kN/m");
    CHECK(text({{0, 2e3}, {5e3, 8e3}}) == "below 2 kN/m, from 5 kN/m to 8 kN/m");
    // a window narrower than the printed digits is stated with digits that show its width
    CHECK(text({{2027.38, 2027.41}, {5e3, 8e3}}) == "from 2.02738 kN/m to 2.02741 kN/m, from 5 kN/m to 8 kN/m");
}

TEST_CASE("two theories whose edges read the same differ nowhere", "[report]")
{
    const auto differ = [](std::vector<Interval> list) {
        return that_read_apart(std::move(list), Quantity::stiffness, Units(Motion::prismatic)).size();
    };
    CHECK(differ({{2027.38, 2027.3801}}) == 0);
    CHECK(differ({{2027.38, 2027.3801}, {87.6e3, 200e9}}) == 1);
    CHECK(differ({{0, 2e3}, {5e3, infinity}}) == 2);
}
