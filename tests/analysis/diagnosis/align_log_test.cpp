// Logs that differ from what their controller had: a column that is late, early or scaled.
#include "analysis/diagnosis/audit/align_log.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

struct Audited {
    std::vector<Case> cases;
    Audit audit;
};

Audited audited(const Record& record, const Joint& joint = test::nominal_joint())
{
    std::vector<Note> notes;
    Audited a{{prepare(record, joint, notes)}, {}};
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

TEST_CASE("a log that ends while its late reference moves is cut, as what its last commands followed is not in it",
          "[gap]")
{
    Record late = test::record_of({}, 1, 0.4);  // quick enough for the last rows to decide
    delay(late.reference_position, 3), delay(late.reference_velocity, 3);
    const auto found = audited(late);
    CHECK(codes_of(found.audit) == std::vector{Note::Code::reference_late});
    CHECK(found.cases[0].ticks.size() == late.time.size() - 3);
    CHECK(found.audit.findings.empty());
}

TEST_CASE("a late reference is shifted under a controller that integrates", "[gap]")
{
    Machine m;
    m.k_i = 3 * m.k_p;
    Joint documented = test::nominal_joint();
    documented.control.k_i = m.k_i;
    Record late = test::record_of(m, 1, 4);
    delay(late.reference_position, 2), delay(late.reference_velocity, 2);
    const auto found = audited(late, documented);
    CHECK(codes_of(found.audit) == std::vector{Note::Code::reference_late});
    CHECK(found.audit.findings.empty());
    CHECK(found.audit.command_explained);
}

TEST_CASE("a reference that is late by one tick of a log of every second one is shifted, and is no feed-forward",
          "[gap]")
{
    Record every = test::record_of({}, 1, 6);
    delay(every.reference_position, 1), delay(every.reference_velocity, 1);
    const auto halved = [](std::vector<double>& column) {
        for (std::size_t k = 0; 2 * k < column.size(); ++k) column[k] = column[2 * k];
        column.resize((column.size() + 1) / 2);
    };
    for (auto* column : {&every.time, &every.position, &every.velocity, &every.effort_command,
                         &every.reference_position, &every.reference_velocity})
        halved(*column);
    const auto found = audited(every);
    CHECK(std::ranges::count(codes_of(found.audit), Note::Code::reference_late) == 1);
    CHECK(found.audit.findings.empty());
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
