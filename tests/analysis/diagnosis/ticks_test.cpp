#include "analysis/diagnosis/records/ticks.h"

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
