#include "analysis/diagnosis/records/ticks.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/records/near_clock.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// A record that keeps every fourth tick of 1 ms of a reference, and what the reference was at every tick.
Ticks of_every_fourth(double (*reference)(double), double (*rate)(double))
{
    Joint j;
    j.mechanism.inertia = 1;
    j.control.k_p = 1;
    j.control.period = 1e-3;
    Record r;
    for (int k = 0; k < 400; k += 4) {
        const double t = 1e-3 * k;
        r.time.push_back(t);
        r.position.push_back(0);
        r.reference_position.push_back(reference(t));
        r.reference_velocity.push_back(rate(t));
    }
    return on_clock(r, j);
}

}  // namespace

TEST_CASE("ramps between the rows of a slow log are where they were, kinks included", "[gap]")
{
    // up from 0.1014 s, down from 0.2011 s, still from 0.3027 s
    const auto ramps = [](double t) {
        return 0.5 * std::max(0.0, t - 0.1014) - 1.2 * std::max(0.0, t - 0.2011) + 0.7 * std::max(0.0, t - 0.3027);
    };
    const auto rate = [](double t) { return t < 0.1014 ? 0.0 : t < 0.2011 ? 0.5 : t < 0.3027 ? -0.7 : 0.0; };
    const Ticks t = of_every_fourth(ramps, rate);
    REQUIRE(t.ticks_per_row == 4);
    for (std::size_t k = 0; k < t.size(); ++k) {
        INFO(t.time[k]);
        CHECK(t.reference[k] == Approx(ramps(t.time[k])).margin(1e-12));
        CHECK(t.reference_rate[k] == Approx(rate(t.time[k])).margin(1e-9));
    }
}

TEST_CASE("a smooth reference between the rows of a slow log is interpolated smoothly", "[gap]")
{
    const auto sine = [](double t) { return std::sin(30 * t); };
    const auto rate = [](double t) { return 30 * std::cos(30 * t); };
    const Ticks t = of_every_fourth(sine, rate);
    // four-point interpolation errs by (ωh)³ at most, straight lines by (ωh)²/8
    for (std::size_t k = 12; k + 12 < t.size(); ++k) {
        CHECK(t.reference[k] == Approx(sine(t.time[k])).margin(2e-4));
        CHECK(t.reference_rate[k] == Approx(rate(t.time[k])).margin(6e-3));
    }
}

TEST_CASE("a drift comes with the time of its record, whatever the clock shows", "[gap]")
{
    constexpr double coulomb = 2, change = -1, tau = 0.5, force = 4;  // of 1 kg
    Joint joint;
    joint.mechanism.inertia = 1;
    CoulombViscous law;
    law.coulomb = coulomb, law.viscous = 0;
    joint.friction.law = law;
    joint.friction.drift = {change, tau};
    joint.control.k_p = 1, joint.control.period = 1e-3;
    // warming up since `earlier`: force less level, integrated twice over time
    const auto moved = [](double t, double earlier) {
        const double left = change * std::exp(-earlier / tau);
        return 0.5 * (force - coulomb - change) * t * t + left * tau * (t - tau * (1 - std::exp(-t / tau)));
    };
    for (const double clock : {0.0, 87.3, 1.7e9})
        for (const double earlier : {0.0, 0.4}) {
            Record record;
            for (int k = 0; k <= 1000; ++k) {
                record.time.push_back(clock + 1e-3 * k);
                record.position.push_back(0);
                record.effort_command.push_back(force);
            }
            if (earlier > 0) record.began = clock - earlier;
            const Ticks ticks = on_clock(record, joint);
            Innovation run;
            predict(flatten(joint), ticks, ticks.command, 0, run);
            CAPTURE(clock, earlier);
            CHECK(std::abs(run.position[1000]) == Approx(moved(1, earlier)).epsilon(1e-5));
        }
}

TEST_CASE("stamps since 1970 are even where they are even to their digits, and scatter where they scatter", "[gap]")
{
    constexpr double epoch = 1795000000.25, tick = 1e-3;
    std::vector<Record> logs(3);
    for (int k = 0; k < 2000; ++k) {
        if (k % 300 != 200) logs[0].time.push_back(epoch + tick * k);
        logs[1].time.push_back(epoch + 100 + tick * k + (k % 2 == 0 ? 2e-6 : -2e-6));
        logs[2].time.push_back(5 + tick * k);
    }
    const auto near = on_near_clocks(logs);
    REQUIRE(near[0].rows() == logs[0].rows());
    for (std::size_t i = 0, k = 0; i < near[0].rows(); ++i, ++k) {
        if (k % 300 == 200) ++k;
        CHECK(near[0].time[i] == Approx(tick * static_cast<double>(k)).margin(3e-7));
        if (i > 0) CHECK(std::remainder(near[0].time[i] - near[0].time[i - 1], tick) == Approx(0).margin(1e-9));
    }
    CHECK(near[1].time[1] - near[1].time[0] == Approx(tick - 4e-6).margin(6e-7));
    CHECK(near[1].time[0] == Approx(100).margin(1e-5));
    CHECK(near[2].time == logs[2].time);
}
