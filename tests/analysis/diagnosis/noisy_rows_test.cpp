#include "analysis/diagnosis/audit/noisy_rows.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/search/attribute.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

/// Root mean square of what the slowest observer, which gathers the most, is surprised by at the rows.
double surprise(const Case& c)
{
    const Plant plant = flatten(c.joint);
    Innovation innovation;
    predict(plant, c.ticks, known_command(plant, c.ticks), levels.back(), innovation);
    double sum = 0;
    for (std::size_t k = 0; k < c.ticks.size(); ++k)
        if (c.ticks.logged[k]) sum += std::pow(innovation.position[k], 2);
    return std::sqrt(sum / static_cast<double>(c.ticks.rows()));
}

}  // namespace

TEST_CASE("noise of the rows of a slow log does not push the simulated joint, an unknown controller's commands do",
          "[gap]")
{
    Machine m;
    m.noise = 2e-5;
    auto nominal = test::nominal_joint();
    nominal.sensor.position_noise = m.noise;
    std::vector<Note> notes;
    const Record slow = test::every_nth_row(test::record_of(m, 1, 6), 5);
    std::vector<Case> cases{prepare(slow, nominal, notes)};
    REQUIRE(cases[0].ticks.ticks_per_row == 5);
    const double with_rows = surprise(cases[0]);
    mark_noisy_rows(cases);
    CHECK(cases[0].ticks.noisy_rows);
    INFO(surprise(cases[0]) << " " << with_rows);
    CHECK(surprise(cases[0]) < 0.8 * with_rows);
    // commands that are computed may be computed with wrong gains: the motion alone shows them
    const auto has_gain = [&] {
        const auto candidates = single_candidates(cases, {});
        return std::ranges::any_of(candidates, [](const Candidate& c) { return c.effects[0]->name == "gain-k_v"; });
    };
    CHECK(has_gain());
    cases[0].ticks.noisy_rows = false;
    CHECK_FALSE(has_gain());
    // what the controller does not explain is no noise
    nominal.control.k_p *= 1.5;
    std::vector<Case> others{prepare(slow, nominal, notes)};
    mark_noisy_rows(others);
    CHECK_FALSE(others[0].ticks.noisy_rows);
}
