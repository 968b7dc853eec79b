// Where a record begins in motion: its velocity, and what a diagnosis makes of it.
#include "analysis/diagnosis/records/start_velocity.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Readings of 0.5 (1 − cos 2πt) from `from` on at 1 kHz.
Ticks swing(double from, double noise, double grid, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Ticks t;
    for (int k = 0; k < 400; ++k) {
        const double time = from + 1e-3 * k, q = 0.5 * (1 - std::cos(2 * pi * time)) + noise * normal(random);
        t.time.push_back(time);
        t.position.push_back(grid > 0 ? grid * std::round(q / grid) : q);
        t.logged.push_back(1);
    }
    return t;
}

}  // namespace

TEST_CASE("the velocity at the start is that of the first row also where the joint accelerates", "[gap][start]")
{
    Ticks cubic = swing(0, 0, 0, 1);
    for (std::size_t k = 0; k < cubic.size(); ++k) {
        const double t = cubic.time[k];
        cubic.position[k] = 3 + 2 * t - 5 * t * t + 40 * t * t * t;
    }
    CHECK(velocity_at_start(cubic).value == Approx(2).epsilon(1e-6));

    for (const double from : {1.0, 1.02, 1.1, 1.25, 1.6, 1.75})
        for (const double noise : {1e-4, 1e-6}) {
            INFO("from " << from << " s, noise " << noise);
            const double true_velocity = pi * std::sin(2 * pi * from);
            constexpr unsigned runs = 40;
            double errors = 0, claimed = 0;
            for (unsigned seed = 1; seed <= runs; ++seed) {
                const auto v = velocity_at_start(swing(from, noise, 0, seed));
                errors += std::pow(v.value - true_velocity, 2), claimed += v.error * v.error;
            }
            CHECK(std::sqrt(errors / runs) <
                  500 * noise);  // 1/s; a line through eight ticks is off by up to 0.08 rad/s
            CHECK(errors < 6 * claimed);
        }
    const double on_grid = velocity_at_start(swing(1.02, 0, 3e-4, 1)).value;
    CHECK(on_grid == Approx(pi * std::sin(2 * pi * 1.02)).margin(0.05));
}

TEST_CASE("a log that begins while the joint accelerates has the gap of one that begins at rest", "[gap][start][slow]")
{
    test::Machine m;
    const auto verdict_from = [](const test::Machine& machine, std::size_t first) {
        const Record whole = test::record_of(machine, 1, 8);
        const auto cut = test::rows_where(whole, [first](std::size_t k) { return k >= first; });
        return test::answer(test::nominal_joint(), {cut}, test::in_order, {}).diagnosis;
    };
    m.amplitude = 8;  // fast against the noise: what the start is off by shows
    for (const std::size_t first : {600u, 1100u, 1700u}) {
        INFO("from row " << first);
        const auto d = verdict_from(m, first);
        for (const auto& reason : d.reasons) UNSCOPED_INFO(name_of(reason.code));
        CHECK(d.verdict == Verdict::no_gap);
    }
    m.coulomb = 2.8;                                 // documented: 2
    for (const std::size_t first : {600u, 1700u}) {  // from row 1100 on: known limits
        INFO("from row " << first);
        const auto d = verdict_from(m, first);
        REQUIRE(d.verdict == Verdict::gap);
        CHECK(d.effects.at(0).names == std::vector<std::string>{"coulomb-level"});
    }
}
