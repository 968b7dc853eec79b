#include "analysis/diagnosis/records/even_clock.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

std::vector<double> even(std::size_t rows, double step)
{
    std::vector<double> t;
    for (std::size_t k = 0; k < rows; ++k) t.push_back(step * static_cast<double>(k));
    return t;
}

std::vector<double> path(const std::vector<double>& times)
{
    std::vector<double> y;
    for (const double t : times) y.push_back(0.5 * std::sin(2 * t));
    return y;
}

}  // namespace

TEST_CASE("stamps that scatter widely are held against the path of the readings", "[gap]")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform{-0.3, 0.3};
    const auto ticks = even(5000, 1e-3);
    auto stamps = ticks;
    for (double& t : stamps) t += 1e-3 * uniform(random);
    const auto times = even_times(stamps, path(ticks), 1e-3);  // the loop read at its ticks
    REQUIRE(times);
    CHECK(times->back() - times->front() == Approx(4.999));
    CHECK_FALSE(even_times(stamps, path(stamps), 1e-3));  // the loop read when the stamps say
}

TEST_CASE("stamps that scatter about the documented period are those of an even loop", "[gap]")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    auto stamps = even(5000, 2e-3);  // every second tick of a loop at 1 kHz
    for (double& t : stamps) t += 0.04 * 2e-3 * normal(random);
    stamps.erase(stamps.begin() + 700, stamps.begin() + 703);  // three rows are lost
    const auto times = even_times(stamps, path(stamps), 1e-3);
    REQUIRE(times);
    REQUIRE(times->size() == stamps.size());
    // told: row k at k · 2 ms, up to one shift for all
    const double shift = times->front();
    CHECK(std::abs(shift) < 2e-5);
    CHECK((*times)[699] - shift == Approx(699 * 2e-3));
    CHECK((*times)[700] - shift == Approx(703 * 2e-3));
    CHECK(times->back() - shift == Approx(4999 * 2e-3));
}

TEST_CASE("a loop that runs unevenly keeps its own times, and an even one, too", "[gap]")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<double> wandering{0};
    for (int k = 1; k < 5000; ++k) wandering.push_back(wandering.back() + 1e-3 * (1 + 0.003 * normal(random)));
    CHECK_FALSE(even_times(wandering, path(wandering), 1e-3));
    CHECK_FALSE(even_times(even(5000, 1e-3), path(even(5000, 1e-3)), 1e-3));
    CHECK_FALSE(even_times(even(5000, 1.3e-3), path(even(5000, 1.3e-3)), 1e-3));  // no multiple of the period
    auto torn = even(5000, 1e-3);
    for (double& t : torn) t += 0.3e-3 * std::abs(normal(random));
    std::sort(torn.begin(), torn.end());
    CHECK_FALSE(even_times(torn, path(torn), 1e-3));
}

TEST_CASE("a wrong gain is read off a command whose time stamps scatter and whose log has holes", "[gap]")
{
    test::Machine m;
    m.k_v *= 1.16;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<Note> notes;
    std::vector<Case> cases;
    for (unsigned seed : {1u, 2u}) {
        Record r = test::record_of(m, seed);
        r.velocity.clear();
        for (double& t : r.time) t += 0.03e-3 * normal(random);
        for (std::size_t hole : {700u, 2100u, 4000u})
            for (auto* column : {&r.time, &r.position, &r.reference_position, &r.reference_velocity, &r.effort_command})
                column->erase(column->begin() + static_cast<std::ptrdiff_t>(hole),
                              column->begin() + static_cast<std::ptrdiff_t>(hole + 3));
        cases.push_back(prepare(r, test::nominal_joint(), notes));
    }
    const Audit found = audit(cases);
    CHECK(found.command_explained);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].effect == "gain-k_v");
    CHECK(found.findings[0].value == Approx(1.16).epsilon(2e-3));
}
