#include "render/drawing/markup.h"

#include <catch2/catch.hpp>

using namespace stickslip::drawing;
using Level = Run::Level;

TEST_CASE("mark-up splits into levels", "[markup]")
{
    CHECK(parse_markup("k_{p}") == std::vector<Run>{{"k", Level::base}, {"p", Level::subscript}});
    CHECK(parse_markup("10^{−6} m") ==
          std::vector<Run>{{"10", Level::base}, {"−6", Level::superscript}, {" m", Level::base}});
    CHECK(parse_markup("x_{a}^{2}") ==
          std::vector<Run>{{"x", Level::base}, {"a", Level::subscript}, {"2", Level::superscript}});
    CHECK(parse_markup("").empty());
    CHECK(parse_markup("_{}").empty());
}

TEST_CASE("everything that is no mark-up stays text", "[markup]")
{
    for (const char* text : {"k_p", "a^2", "k_{p", "{x}", "}", "_", "^{", "100 % < 3 & 4"})
        CHECK(parse_markup(text) == std::vector<Run>{{text, Level::base}});
    CHECK(plain_text("k_{cr} = 10^{4}") == "kcr = 104");
}
