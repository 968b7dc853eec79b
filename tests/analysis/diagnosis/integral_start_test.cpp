// Controllers with an integral in logs that do not say all of it: cut out of a longer one, or without the reference.
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

test::Machine integrating()
{
    test::Machine m;
    m.k_i = 6000, m.amplitude = 4, m.gravity = 8;
    return m;
}

Joint documented()
{
    Joint joint = test::nominal_arm();
    joint.control.k_i = integrating().k_i;
    joint.load.gravity_amplitude = integrating().gravity;
    return joint;
}

Diagnosis diagnosis_of(const Record& record)
{
    auto d = test::answer(documented(), {record}, test::in_order, {}).diagnosis;
    for (const auto& reason : d.reasons) UNSCOPED_INFO(name_of(reason.code));
    return d;
}

Record cut(const test::Machine& machine, std::size_t first)
{
    return test::rows_where(test::record_of(machine, 1, 8), [first](std::size_t k) { return k >= first; });
}

Record without_reference(const test::Machine& machine)
{
    Record r = test::record_of(machine, 1, 8);
    r.reference_position.clear(), r.reference_velocity.clear();
    return r;
}

}  // namespace

TEST_CASE("a cut log of a loop with an integral begins with what the integral held", "[gap][start][slow]")
{
    for (const std::size_t first : {900u, 1600u}) {
        INFO("from row " << first);
        CHECK(diagnosis_of(cut(integrating(), first)).verdict == Verdict::no_gap);
        test::Machine other = integrating();
        other.k_i = 9000;
        const auto d = diagnosis_of(cut(other, first));
        REQUIRE(d.verdict == Verdict::gap);
        CHECK(d.effects.at(0).names == std::vector<std::string>{"gain-k_i"});
        CHECK(d.overall.after < 2);
    }
}

TEST_CASE("without its reference a loop with an integral is judged under its command", "[gap][start][slow]")
{
    const auto own = diagnosis_of(without_reference(integrating()));
    CHECK(own.verdict == Verdict::no_gap);
    CHECK(std::ranges::any_of(own.notes, [](const Note& n) { return n.code == Note::Code::controller_unseen; }));
    test::Machine other = integrating();
    other.viscous = 3;
    const auto d = diagnosis_of(without_reference(other));
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"viscous"});
}

TEST_CASE("what an integral held at the start is that of the controller as it was found", "[gap][start]")
{
    // the feed-forward that the document has and the machine has not looked like an integral of the opposite effort
    Joint joint = documented();
    joint.control.feed_forward.coulomb = 1;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(test::record_of(integrating(), 1), joint, notes)};
    cases[0].ticks.initial_integral = 1e-3;
    cases[0].joint.control.feed_forward.coulomb = 0;
    find_integrals(cases);
    CHECK(cases[0].ticks.initial_integral == 0);
}
