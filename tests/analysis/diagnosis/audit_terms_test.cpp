// Terms of a controller that no document has, in commands that nothing reproduces to digits.
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using stickslip::test::in_order;
using stickslip::test::Machine;

TEST_CASE("a feed-forward of an acceleration that the log shows only roughly is named", "[gap][slow]")
{
    Machine m;
    m.fed = 1.2;  // all of the inertia
    const auto d =
        test::answer(test::nominal_joint(), {test::record_of(m, 1), test::record_of(m, 2)}, in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"feed-forward"});
    REQUIRE(d.effects[0].parameters.size() == 1);
    CHECK(d.effects[0].parameters[0].name == "feed-forward.acceleration");
    CHECK(d.effects[0].parameters[0].value == Approx(1.2).epsilon(0.03));
}
