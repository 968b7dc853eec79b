// Logs that lost rows, were interrupted or cut out of longer ones: the simulated machine knows what is missing.
#include "analysis/diagnosis/records/pieces.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Record heavier()
{
    test::Machine m;
    m.inertia = 1.26;  // documented: 1.2
    return test::record_of(m, 1, 8);
}

Diagnosis answer(const Record& record)
{
    return test::answer(test::nominal_joint(), {record}, test::in_order, {}).diagnosis;
}

void names_inertia(const Diagnosis& d)
{
    for (const auto& reason : d.reasons) UNSCOPED_INFO(name_of(reason.code));
    CHECK(d.verdict == Verdict::gap);
    REQUIRE_FALSE(d.effects.empty());
    CHECK(d.effects[0].names == std::vector<std::string>{"inertia"});
}

}  // namespace

TEST_CASE("lost rows of a regular log are ticks without a row", "[gap]")
{
    const Record whole = test::record_of({}, 1, 1);
    const auto lost = [](std::size_t k) { return k % 7 == 3 || (k > 500 && k < 512); };
    const Ticks t = on_clock(test::rows_where(whole, [&](std::size_t k) { return !lost(k); }), test::nominal_joint());
    CHECK(t.lost);
    CHECK(t.ticks_per_row == 1);
    REQUIRE(t.size() == whole.rows());
    for (std::size_t k = 0; k < t.size(); ++k) {
        CHECK(t.logged[k] == !lost(k));
        CHECK(t.time[k] == Approx(whole.time[k]).margin(1e-12));
        CHECK(is_set(t.command[k]) == !lost(k));
        CHECK(t.position[k] == Approx(whole.position[k]).margin(lost(k) ? 2e-4 : 0));
        CHECK(t.reference[k] == Approx(whole.reference_position[k]).margin(1e-4));
    }
    CHECK_FALSE(on_clock(whole, test::nominal_joint()).lost);
}

TEST_CASE("a hole in time parts a record, and what comes after it starts as it moved", "[gap]")
{
    const Record whole = test::record_of({}, 1);
    const Record holed = test::rows_where(whole, [](std::size_t k) { return k < 2000 || k >= 2500; });
    std::vector<Note> notes;
    const auto parts = pieces(holed, notes);
    REQUIRE(parts.size() == 2);
    CHECK(notes.at(0).code == Note::Code::holes);
    CHECK(notes.at(0).values == std::vector<double>{1, whole.time[1999], 2.5});
    CHECK(parts[0].rows() == 2000);
    CHECK(parts[1].time.front() == 2.5);
    CHECK(parts[1].began == whole.time[0]);  // it goes on to warm up
    CHECK(parts[1].position.front() == whole.position[2500]);
    CHECK(pieces(whole, notes).size() == 1);
    const double speed = (whole.position[2504] - whole.position[2496]) / 8e-3;
    REQUIRE(std::abs(speed) > 0.02);
    const Case after = prepare(parts[1], test::nominal_joint(), notes);
    CHECK_FALSE(after.ticks.at_rest);
    CHECK(after.ticks.initial_velocity == Approx(speed).epsilon(0.2));
    // said to be at rest, it is
    Record told = parts[1];
    told.at_rest_at_start = true;
    CHECK(prepare(told, test::nominal_joint(), notes).ticks.at_rest);
    CHECK(prepare(parts[0], test::nominal_joint(), notes).ticks.at_rest);
}

TEST_CASE("what the controller had filtered before a hole is no gap of the command", "[gap][slow]")
{
    const auto d = answer(test::rows_where(heavier(), [](std::size_t k) { return k < 3000 || k >= 3700; }));
    REQUIRE(d.signals.size() == 2);
    CHECK(d.signals[0].name == "command");
    CHECK(d.signals[0].rms < 1e-5);
    CHECK(d.signals[1].share > 0.99);
}

TEST_CASE("a force that nobody modelled sets a joint in motion from rest: that is no start in motion", "[gap]")
{
    test::Machine m;
    m.load = 12;
    std::vector<Note> notes;
    CHECK(prepare(test::record_of(m, 2), test::nominal_joint(), notes).ticks.at_rest);
}

TEST_CASE("the cause is found in logs with lost rows, with a hole, and cut out of longer ones", "[gap][slow]")
{
    const Record whole = heavier();
    names_inertia(answer(whole));
    names_inertia(answer(test::rows_where(whole, [](std::size_t k) { return k % 5 != 2; })));
    names_inertia(answer(test::rows_where(whole, [](std::size_t k) { return k < 3000 || k >= 3700; })));
    names_inertia(answer(test::rows_where(whole, [](std::size_t k) { return k >= 1700; })));
}
