// A feed-forward that the file does not have, where no command was logged but the effort was measured: motion alone
// does not tell it from another inertia.
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::in_order;
using stickslip::test::Machine;

namespace {

std::vector<Record> without_command(Machine m, double effort_noise)
{
    m.effort_noise = effort_noise;
    std::vector<Record> records;
    for (const unsigned seed : {1U, 3U}) {
        records.push_back(test::record_of(m, seed, 3));
        records.back().effort_command.clear();
    }
    return records;
}

Diagnosis answer_to(const std::vector<Record>& records)
{
    return test::answer(test::nominal_joint(), records, in_order).diagnosis;
}

}  // namespace

TEST_CASE("a feed-forward that the document lacks is named from motion and measured effort", "[gap][slow]")
{
    Machine m;
    m.pushed = 1.5;  // N, three quarters of the Coulomb level
    const auto d = answer_to(without_command(m, 0.02));
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects[0].names == std::vector<std::string>{"feed-forward"});
    for (const auto& p : d.effects[0].parameters)
        if (p.name == "feed-forward.coulomb") CHECK(p.value == Approx(1.5).epsilon(0.03));
}

TEST_CASE("an inertia that is wrong stays an inertia beside a feed-forward that could do the same", "[gap][slow]")
{
    Machine m;
    m.inertia *= 1.4;
    for (const double effort_noise : {0.02, 0.0}) {
        CAPTURE(effort_noise);
        const auto d = answer_to(without_command(m, effort_noise));
        REQUIRE(d.verdict == Verdict::gap);
        CHECK(d.effects[0].names == std::vector<std::string>{"inertia"});
    }
}
