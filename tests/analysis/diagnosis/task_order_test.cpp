// A diagnosis does not depend on the order in which its tasks run.
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

TEST_CASE("the order of the tasks changes no bit of a diagnosis", "[gap][slow]")
{
    test::Machine m;
    m.coulomb = 2.3;
    const std::vector<Record> records{test::record_of(m, 1), test::record_of(m, 2)};
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto answer = [&](const ParallelFor& tasks) {
        return test::answer(test::nominal_joint(), records, tasks, options).diagnosis;
    };
    const auto first = answer(test::in_order);
    const auto again = answer([](std::size_t n, const std::function<void(std::size_t)>& task) {
        for (std::size_t i = n; i-- > 0;) task(i);
    });
    REQUIRE(!first.effects.empty());
    REQUIRE(!again.effects.empty());
    CHECK(again.effects[0].parameters[0].value == first.effects[0].parameters[0].value);
    CHECK(again.overall.after == first.overall.after);
}
