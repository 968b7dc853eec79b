#include <catch2/catch.hpp>

#include "sweep/report/pages/first_screen.h"

using namespace stickslip;
using Catch::Matchers::Contains;

TEST_CASE("faster than its window a joint is not smooth until the next window begins", "[report]")
{
    VelocitySearch search;
    search.velocity = 1e-3, search.low = 1e-6, search.high = 1;
    search.found.intervals = {{1e-6, 2e-3}, {1e-2, 3e-2}, {5e-2, 1}};
    search.found.least = 1e-6;
    search.found.all_above = 5e-2;
    const auto cards = velocity_headlines(search, true, Units(Motion::prismatic));
    REQUIRE(cards.size() == 2);
    CHECK(cards[1].value == "2 mm/s");
    CHECK_THAT(cards[1].meaning, Contains("then not, up to 10 mm/s"));
}

TEST_CASE("of a joint that moves backwards the first screen tells speeds", "[report][backwards]")
{
    VelocitySearch search;
    search.velocity = -1e-3, search.low = -1, search.high = -1e-6;
    search.found.intervals = {{-1, -5e-2}, {-3e-2, -1e-2}, {-2e-3, -1e-6}};
    search.found.least = -1e-6;
    search.found.all_above = -5e-2;
    const auto cards = velocity_headlines(search, true, Units(Motion::prismatic));
    REQUIRE(cards.size() == 2);
    CHECK(cards[0].value == "V_{min} = 50 mm/s, backwards");
    CHECK_THAT(cards[0].meaning, Contains("smooth from 1 µm/s or slower to 2 mm/s"));
    CHECK(cards[1].value == "2 mm/s, backwards");
    CHECK_THAT(cards[1].meaning, Contains("then not, up to 10 mm/s"));
}
