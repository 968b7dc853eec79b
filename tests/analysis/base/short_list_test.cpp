#include "analysis/base/field.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("a short list in braces has the numbers that stand there", "[base]")
{
    NumberList list;
    list = {1.5};
    REQUIRE(list.size == 1);
    CHECK(list[0] == 1.5);
    list = {1, 0.5, 0.25};
    REQUIRE(list.size == 3);
    CHECK(list[2] == 0.25);
    CHECK(NumberList{}.size == 0);
    using Pair = ShortList<int, 2>;
    CHECK_THROWS_AS((Pair{1, 2, 3}), std::length_error);
}
