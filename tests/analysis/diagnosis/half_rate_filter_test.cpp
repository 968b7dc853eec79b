#include "analysis/diagnosis/audit/half_rate_filter.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <random>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

/// Every second row of a machine's record; an encoder without steps.
Case logged_at_half_rate(Machine m, double documented_tau)
{
    m.quantum = 1e-12;
    const Record half = test::every_nth_row(test::record_of(m, 1, 5), 2);
    Joint joint = test::nominal_joint();
    joint.sensor.encoder_quantum = 0, joint.sensor.position_noise = m.noise;
    joint.control.velocity_estimate.tau = documented_tau;
    std::vector<Note> notes;
    return prepare(half, joint, notes);
}

}  // namespace

TEST_CASE("half-rate filter: white noise alone gives the slope that its formula says", "[gap]")
{
    const double g = GENERATE(0.05, 0.2, 0.5, 0.9, 1.0);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    double last = 0, v = 0, before = 0, position_before = 0, both = 0, square = 0;
    for (int k = 0; k < 400000; ++k) {
        const double y = normal(random);
        v += g * (y - last - v), last = y;
        if (k % 2) continue;
        const double rate = (y - position_before) / 2;
        if (k > 1000) both += (v - rate) * (before - rate), square += (before - rate) * (before - rate);
        before = v, position_before = y;
    }
    CHECK(slope_of_noise(g) == Approx(both / square).margin(0.01));
}

TEST_CASE("half-rate filter: another filter than the documented one is a finding, the documented one is none",
          "[gap][slow]")
{
    Machine m;
    m.tau = GENERATE(0.0, 0.003, 0.009);
    m.noise = GENERATE(2e-6, 1e-4);
    const double documented = GENERATE(0.0, 0.003, 0.009);
    CAPTURE(m.tau, m.noise, documented);
    std::vector<Case> cases{logged_at_half_rate(m, documented)};
    REQUIRE(cases[0].ticks.rebuilt);
    const auto shares = filter_shares_of_halves(cases);
    const double share = 1e-3 / (m.tau + 1e-3);
    if (shares) {
        CHECK(shares->by_motion < 1.03 * share);
        CHECK(shares->by_noise > 0.97 * share);
    }
    const auto found = audit(cases);
    const bool finding =
        std::ranges::any_of(found.findings, [](const auto& f) { return f.effect == "velocity-filter"; });
    CHECK(finding == (documented != m.tau));
    if (finding && m.tau > 0) CHECK(cases[0].joint.control.velocity_estimate.tau == Approx(m.tau).epsilon(0.05));
}
