#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;
using stickslip::test::nominal_joint;
using stickslip::test::record_of;

namespace {

std::vector<Case> cases_of(const Machine& m, double seconds)
{
    std::vector<Note> notes;
    return {prepare(record_of(m, 3, seconds), nominal_joint(), notes)};
}

}  // namespace

TEST_CASE("an excerpt keeps the clock, the worst second and the budget", "[gap]")
{
    auto cases = cases_of({}, 20);
    // half a second in which the record is not what any joint does
    for (std::size_t k = 12300; k < 12800; ++k) cases[0].ticks.position[k] += 1e-3;
    const auto some = excerpts(cases, 50, 8000, 2);
    const Ticks &whole = cases[0].ticks, &part = some[0].ticks;
    CHECK(part.size() < 9000);
    CHECK(part.size() > 6000);
    REQUIRE(part.judged.size() == part.size());
    std::size_t bad = 0;
    for (std::size_t k = 0; k < part.size(); ++k) {
        const auto from = static_cast<std::size_t>(std::lround(part.time[k] / 1e-3));
        REQUIRE(part.position[k] == whole.position[from]);
        REQUIRE(part.command[k] == whole.command[from]);
        if (k > 0) REQUIRE(part.time[k] > part.time[k - 1]);
        bad += part.judged[k] && from >= 12300 && from < 12800;
    }
    CHECK(bad == 500);
}

TEST_CASE("a prediction that starts anew has found the state of the whole record where it is judged", "[gap]")
{
    const auto cases = cases_of({}, 20);
    const auto some = excerpts(cases, 50, 8000, 1);
    const Ticks &whole = cases[0].ticks, &part = some[0].ticks;
    REQUIRE(part.restarts.size() > 1);
    const Plant plant = flatten(cases[0].joint);
    for (const double omega : levels) {
        Innovation all, cut;
        predict(plant, whole, whole.command, omega, all);
        predict(plant, part, part.command, omega, cut);
        double difference = 0, size = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (!part.judged[k]) continue;
            const auto from = static_cast<std::size_t>(std::lround(part.time[k] / 1e-3));
            difference += std::pow(cut.position[k] - all.position[from], 2);
            size += std::pow(all.position[from], 2);
        }
        INFO("observer at " << omega << " rad/s");
        CHECK(difference < 1e-3 * size);
    }
}

TEST_CASE("short records stay whole", "[gap]")
{
    const auto cases = cases_of({}, 6);
    const auto some = excerpts(cases, 50, 8000, 2);
    CHECK(some[0].ticks.size() == cases[0].ticks.size());
    CHECK(some[0].ticks.judged.empty());
    CHECK(some[0].step_factor == 2);
}

TEST_CASE("an excerpt of a loop that integrates has the integral of the whole record", "[gap]")
{
    // a log of every second tick: the commands between its rows are the controller's, and its integral stands in them
    Joint joint = nominal_joint();
    joint.control.k_i = 2e4;
    const Record record = record_of({}, 3, 20);
    Record slow = test::every_nth_row(record, 2);
    slow.velocity.clear(), slow.reference_velocity.clear();
    std::vector<Note> notes;
    const Case whole = prepare(slow, joint, notes);
    REQUIRE(whole.ticks.ticks_per_row == 2);
    const Ticks part = excerpts({whole}, 50, 8000, 1)[0].ticks;
    REQUIRE(part.restarts.size() > 1);
    const Plant plant = flatten(joint);
    const auto all = command_of(plant, whole.ticks), cut = command_of(plant, part);
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < part.size(); ++k) {
        if (!part.judged[k]) continue;
        const auto from = static_cast<std::size_t>(std::lround(part.time[k] / 1e-3));
        difference = std::max(difference, std::abs(cut[k] - all[from]));
        size = std::max(size, std::abs(all[from]));
    }
    CHECK(difference < 1e-3 * size);
}
