// Which numbers of a joint have changed since its baseline.
#include <catch2/catch.hpp>

#include "sweep/study/check/numbers.h"

using namespace stickslip;

TEST_CASE("numbers that a joint had, lost or got since its baseline", "[check]")
{
    const std::map<std::string, double> before{{"control.k_p", 1e4}, {"friction.A", 1}};
    std::map<std::string, double> after{{"control.k_p", 2e4}, {"control.V0", 1e-3}};
    const auto changed = changed_numbers(before, after);
    REQUIRE(changed.size() == 3);
    CHECK((changed[0].path == "control.k_p" && changed[0].before == 1e4 && changed[0].after == 2e4));
    CHECK((changed[1].path == "friction.A" && changed[1].before == 1 && !is_set(changed[1].after)));
    CHECK((changed[2].path == "control.V0" && !is_set(changed[2].before) && changed[2].after == 1e-3));
}

TEST_CASE("a key that the baseline's program did not know has not changed while it stands at its default", "[check]")
{
    const std::map<std::string, double> before{{"control.k_p", 1e4}};
    CHECK(changed_numbers(before, {{"control.k_p", 1e4}, {"control.delay", 0}, {"sensor.position_scale", 1}}).empty());
    CHECK(changed_numbers(before, {{"control.k_p", 1e4}, {"control.delay", 1e-3}}).size() == 1);
}
