#include "sweep/words/stage_text.h"

#include <catch2/catch.hpp>

#include <limits>

using stickslip::time_left_text;

TEST_CASE("the time left follows from the part that is done, from a tenth on", "[words]")
{
    CHECK(time_left_text(0.09, 50).empty());
    CHECK(time_left_text(0.1, 10) == "about 90 s left");
    CHECK(time_left_text(0.5, 600) == "about 10 min left");
    CHECK(time_left_text(0.999, 1) == "about 1 s left");
    CHECK(time_left_text(1, 50).empty());
    CHECK(time_left_text(std::numeric_limits<double>::quiet_NaN(), 50).empty());
}
