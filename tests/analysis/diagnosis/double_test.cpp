// Causes that make one motion, where the document is a little off as well.
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using stickslip::test::Machine;

TEST_CASE("an encoder's zero and gravity at another angle are told apart by no amplitude that is 2 % off",
          "[gap][slow]")
{
    Machine m;
    m.gravity = 5, m.gravity_angle = 0.16, m.amplitude = 4;
    Joint joint = test::nominal_arm();
    joint.load.gravity_amplitude = 5 * 1.02;
    const auto d = test::answer(joint, {test::record_of(m, 1), test::record_of(m, 2)}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto chance = [&](const char* name) {
        const auto cause = std::ranges::find(d.effects, std::vector<std::string>{name}, &Cause::names);
        return cause == d.effects.end() ? 0.0 : cause->probability;
    };
    CHECK(chance("gravity") > 0.3);
    CHECK(chance("sensor-offset") > 0.3);
}
