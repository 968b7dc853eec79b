#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// A free mass of 2 kg without a command, simulated open-chain; where it is after one second.
double drifted_to(const Record& known)
{
    Joint j = test::nominal_joint();
    j.mechanism.inertia = 2;
    CoulombViscous none;
    none.coulomb = none.viscous = 0;
    j.friction.law = none;
    Record r = known;
    for (int k = 0; k <= 1000; ++k) {
        r.time.push_back(1e-3 * k), r.position.push_back(0), r.effort_command.push_back(0);
    }
    const Ticks ticks = on_clock(r, j);
    Innovation run;
    predict(flatten(j), ticks, ticks.command, 0, run);
    return -run.position.back();
}

}  // namespace

TEST_CASE("a known load and a known inertia move the mass by Newton's law", "[gap]")
{
    Record r;
    r.load_effort.assign(1001, 3);
    CHECK(drifted_to(r) == Approx(0.5 * 3 / 2.0).epsilon(1e-3));
    r.inertia.assign(1001, 6);
    CHECK(drifted_to(r) == Approx(0.5 * 3 / 6.0).epsilon(1e-3));
    // F = 3 t: q = t³/(2·6). Held over every tick of a millisecond it would come half of one late: 1.5e-3 less
    for (std::size_t k = 0; k < 1001; ++k) r.load_effort[k] = 3e-3 * static_cast<double>(k);
    CHECK(drifted_to(r) == Approx(3.0 / 6 / 6).epsilon(1e-5));
    r.load_effort.assign(1001, 3);  // M = 1 + t: v = 3 ln(1 + t), q = 3 ((1 + t) ln(1 + t) - t)
    for (std::size_t k = 0; k < 1001; ++k) r.inertia[k] = 1 + 1e-3 * static_cast<double>(k);
    CHECK(drifted_to(r) == Approx(3 * (2 * std::log(2.0) - 1)).epsilon(1e-5));
}

TEST_CASE("a logged feed-forward is no fault of the controller, an unlogged one is not taken for a gain", "[gap]")
{
    Record r = test::record_of({}, 1, 4);
    for (std::size_t k = 0; k < r.rows(); ++k) {
        r.feed_forward.push_back(4 * std::sin(2 * r.time[k]));
        r.effort_command[k] += r.feed_forward[k];
    }
    const auto audited = [](const Record& record) {
        std::vector<Note> notes;
        std::vector<Case> cases{prepare(record, test::nominal_joint(), notes)};
        return audit(cases);
    };
    const auto with = audited(r);
    CHECK(with.command_explained);
    CHECK(with.findings.empty());
    r.feed_forward.clear();
    CHECK_FALSE(audited(r).command_explained);
}

TEST_CASE("what noise makes of a joint is measured with the load and the inertia that its record knows", "[gap]")
{
    Record r = test::record_of({}, 1, 4);
    for (const double t : r.time) {
        r.load_effort.push_back(5 * std::sin(3 * t));
        r.inertia.push_back(test::nominal_joint().mechanism.inertia * (1 + 0.5 * std::sin(2 * t)));
        r.feed_forward.push_back(2 * std::cos(t));
    }
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    const NoiseSpread spread = spread_of(cases, {}, {}, 3, test::in_order);
    REQUIRE(spread.simulated);
    for (std::size_t l = 0; l < levels.size(); ++l) CHECK(spread.mean[l][0].position == Approx(1).margin(0.3));
}

TEST_CASE("what a known load is wrong by is in the floor of a prediction and in noisy runs", "[gap]")
{
    constexpr double E = 0.5, w = 30, zeta = 0.8;
    Joint j = test::nominal_joint();
    j.friction.law = CoulombViscous{.coulomb = 0, .viscous = 0};
    j.sensor.encoder_quantum = 0, j.sensor.position_noise = 1e-7;
    Record r;
    r.name = "free.csv";
    for (int k = 0; k < 8000; ++k) {
        r.time.push_back(1e-3 * k);
        r.load_error.push_back(E * std::sin(w * r.time.back()));
    }
    r.position.assign(r.time.size(), 0);
    r.reference_position = r.effort_command = r.load_effort = r.position;
    std::vector<Note> notes;
    const Case c = prepare(r, j, notes);
    for (const double omega : levels) {
        // d'' + 2 zeta omega d' + omega² d = e/M
        const double gain = 1 / std::hypot(omega * omega - w * w, 2 * zeta * omega * w);
        const double expected = E / j.mechanism.inertia * gain / std::sqrt(2.0);
        const double passed_on = std::sqrt(noise_amplification(omega, c.row_step));
        const double by_load = std::sqrt(std::pow(reading_floor(c, omega), 2) - c.sigma * c.sigma) * passed_on;
        CHECK(by_load == Approx(expected).epsilon(0.03));
    }
    const auto run = [&](double sign, std::uint64_t seed, bool wrong) {
        Ticks t = c.ticks;
        for (std::size_t k = 0; k < t.size(); ++k) t.load[k] += sign * t.load_error[k];
        if (!wrong) t.load_error.clear();
        return simulate_closed_loop(flatten(c.joint), t, seed).true_position;
    };
    CHECK(run(0, 1, true) == run(1, 1, false));   // odd seeds have it,
    CHECK(run(0, 2, true) == run(-1, 2, false));  // even ones its opposite,
    CHECK(run(0, 0, true) == run(0, 0, false));   // and a run without noise none of it
}
