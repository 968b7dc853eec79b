// Logs that differ from what their controller had: a column that is late, early or scaled.
#include "analysis/diagnosis/audit/align_log.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

struct Audited {
    std::vector<Case> cases;
    Audit audit;
};

Audited audited(const Record& record)
{
    std::vector<Note> notes;
    Audited a{{prepare(record, test::nominal_joint(), notes)}, {}};
    a.audit = audit(a.cases);
    return a;
}

/// The column as a logger writes it that is so many rows late.
void delay(std::vector<double>& column, std::size_t rows)
{
    column.insert(column.begin(), rows, column.front());
    column.resize(column.size() - rows);
}

std::vector<Note::Code> codes_of(const Audit& audit)
{
    std::vector<Note::Code> codes;
    for (const auto& note : audit.notes) codes.push_back(note.code);
    return codes;
}

}  // namespace

TEST_CASE("a reference that is logged late is shifted, and no gain is blamed", "[gap]")
{
    const Record whole = test::record_of({}, 1, 4);
    Record late = whole;
    delay(late.reference_position, 2), delay(late.reference_velocity, 2);
    const auto found = audited(late);
    CHECK(codes_of(found.audit) == std::vector{Note::Code::reference_late});
    CHECK(found.audit.findings.empty());
    CHECK(found.audit.command_explained);
    CHECK(found.audit.notes[0].values[0] == 2);
    CHECK(found.cases[0].ticks.reference[1000] == whole.reference_position[1000]);
}

TEST_CASE("a reference that is logged early is shifted beside a wrong gain, which is named", "[gap]")
{
    Machine m;
    m.k_p *= 1.2;
    Record early = test::record_of(m, 1, 4);
    for (auto* column : {&early.position, &early.velocity, &early.effort_command}) delay(*column, 1);
    const auto found = audited(early);
    CHECK(codes_of(found.audit) == std::vector{Note::Code::reference_early});
    REQUIRE(found.audit.findings.size() == 1);
    CHECK(found.audit.findings[0].effect == "gain-k_p");
    CHECK(found.audit.findings[0].value == Approx(1.2).epsilon(1e-3));
}

TEST_CASE("positions that a log converts by another gear ratio are those of the controller again", "[gap]")
{
    const Record whole = test::record_of({}, 1, 4);
    Record scaled = whole;
    for (double& y : scaled.position) y *= 1.02;
    for (double& v : scaled.velocity) v *= 1.02;
    const auto found = audited(scaled);
    REQUIRE(codes_of(found.audit) == std::vector{Note::Code::positions_scaled});
    CHECK(found.audit.notes[0].values[0] == Approx(1.02).epsilon(1e-4));
    CHECK(found.audit.findings.empty());
    CHECK(found.cases[0].ticks.position[1000] == Approx(whole.position[1000]).epsilon(1e-4));
}

TEST_CASE("a log that is its controller's stays as it is, with a wrong gain, too", "[gap]")
{
    Machine m;
    m.k_v *= 0.7;
    const auto found = audited(test::record_of(m, 1, 4));
    CHECK(found.audit.notes.empty());
    REQUIRE(found.audit.findings.size() == 1);
    CHECK(found.audit.findings[0].effect == "gain-k_v");
}
