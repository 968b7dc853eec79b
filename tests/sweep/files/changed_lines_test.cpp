#include <catch2/catch.hpp>

#include "sweep/files/toml/changed_lines.h"

using namespace stickslip;

TEST_CASE("lines to paste have the digits that somebody types, and the documented value", "[toml]")
{
    const auto text = changed_lines("[actuator]\nlag = 0.30000000000000004   # s\nkind = \"effort\"\n",
                                    "[actuator]\nlag = 0.009329370299992392   # s\nkind = \"dc-motor\"\nk_t = inf\n");
    CHECK(text ==
          "[actuator]\n"
          "lag = 0.00932937   # s, documented: 0.3\n"
          "kind = \"dc-motor\"   # documented: \"effort\"\n"
          "k_t = inf   # not in the documented file\n");
}

TEST_CASE("a change below the digits that anybody types is no line", "[files]")
{
    CHECK(stickslip::changed_lines("[joint]\ninertia = 1.1   # kg·m²\n",
                                   "[joint]\ninertia = 1.0999999165818268   # kg·m²\n") == "");
}
