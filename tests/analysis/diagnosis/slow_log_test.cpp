// The controller of logs that hold some ticks of the loop only, with velocities and without.
#include "analysis/diagnosis/audit/slow_log.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

Record slow_record(const Machine& m, unsigned seed, int ticks, bool velocities = false)
{
    Record r = test::every_nth_row(test::record_of(m, seed, 6), ticks);
    if (!velocities) r.velocity.clear();
    return r;
}

std::vector<Case> slow_cases(const Machine& m, int ticks, const Joint& joint = test::nominal_joint(),
                             bool velocities = false)
{
    std::vector<Note> notes;
    std::vector<Case> cases;
    for (const unsigned seed : {1u, 2u})
        cases.push_back(prepare(slow_record(m, seed, ticks, velocities), joint, notes));
    return cases;
}

}  // namespace

TEST_CASE("what acts on the joint is no change of its controller in a slow log", "[gap]")
{
    Machine m;
    m.drag = 200, m.cogging = 0.6, m.load = 0.5, m.noise = 2e-5;
    for (const int ticks : {2, 5, 8}) {
        CAPTURE(ticks);
        auto cases = slow_cases(m, ticks);
        REQUIRE(is_slow_log(cases));
        const Audit found = audit(cases);
        CHECK(found.findings.empty());
        CHECK(found.possible);
        CHECK(cases[0].joint.control.k_p == test::nominal_joint().control.k_p);
    }
}

TEST_CASE("a slow log tells the gain of its controller, also beside lost rows", "[gap]")
{
    Machine m;
    m.k_p = 1100;  // documented: 1200
    m.noise = 2e-5;
    for (const bool lost : {false, true}) {
        CAPTURE(lost);
        std::vector<Note> notes;
        std::vector<Case> cases;
        for (const unsigned seed : {1u, 2u}) {
            Record r = slow_record(m, seed, 4);
            if (lost) r = test::rows_where(r, [](std::size_t k) { return k != 300; });
            cases.push_back(prepare(r, test::nominal_joint(), notes));
        }
        REQUIRE(cases[0].ticks.lost == lost);
        const Audit found = audit(cases);
        REQUIRE(found.findings.size() == 1);
        CHECK(found.findings[0].parameter == "gain-k_p.factor");
        CHECK(found.findings[0].value == Approx(1100.0 / 1200).epsilon(0.01));
        CHECK(cases[1].joint.control.k_p == Approx(1100).epsilon(0.01));
    }
}

TEST_CASE("a slow log tells the filter of its controller, with logged velocities, too", "[gap]")
{
    Machine m;
    m.tau = 8e-3;  // documented: 3 ms
    for (const bool logged : {false, true}) {
        CAPTURE(logged);
        auto cases = slow_cases(m, 4, test::nominal_joint(), logged);
        REQUIRE(cases[0].ticks.has_velocity == logged);
        const Audit found = audit(cases);
        // nothing is said of the documented controller, which did not run
        CHECK(std::ranges::none_of(found.notes,
                                   [](const Note& note) { return note.code == Note::Code::command_unknown; }));
        REQUIRE(found.findings.size() == 1);
        CHECK(found.findings[0].parameter == "velocity-filter.tau");
        CHECK(found.findings[0].value == Approx(8e-3).epsilon(0.15));
    }
}

TEST_CASE("a slow log tells an integral and a dead zone", "[gap]")
{
    Machine m;
    m.k_i = 3000, m.load = 1;
    Joint joint = test::nominal_joint();
    joint.control.k_i = 2500;
    auto integrating = slow_cases(m, 4, joint);
    const Audit integral = audit(integrating);
    REQUIRE(integral.findings.size() == 1);
    CHECK(integral.findings[0].parameter == "gain-k_i.factor");
    CHECK(integral.findings[0].value == Approx(1.2).epsilon(0.02));

    Machine dead;
    dead.dead_zone = 4e-4;
    auto zoned = slow_cases(dead, 4);
    const Audit zone = audit(zoned);
    REQUIRE(zone.findings.size() == 1);
    CHECK(zone.findings[0].parameter == "dead-zone.width");
    CHECK(zone.findings[0].value == Approx(4e-4).epsilon(0.25));
}

TEST_CASE("a slow log with velocities tells an integral that no row by itself shows", "[gap]")
{
    Machine m;
    m.k_i = 2800, m.load = 1, m.noise = 3e-4;
    Joint joint = test::nominal_joint();
    joint.control.k_i = 2500;
    auto cases = slow_cases(m, 8, joint, true);
    REQUIRE(cases[0].ticks.has_velocity);
    const Audit found = audit(cases);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].parameter == "gain-k_i.factor");
    CHECK(found.findings[0].value == Approx(1.12).epsilon(0.02));
}

TEST_CASE("gains that differ from record to record are not one controller's", "[gap]")
{
    std::vector<Note> notes;
    std::vector<Case> cases;
    Machine m;
    m.k_p = 900;
    cases.push_back(prepare(slow_record(m, 1, 4), test::nominal_joint(), notes));
    m.k_p = 1200;
    cases.push_back(prepare(slow_record(m, 2, 4), test::nominal_joint(), notes));
    CHECK(audit(cases).findings.empty());
}
