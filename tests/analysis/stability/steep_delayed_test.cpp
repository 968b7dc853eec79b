// Friction of a link that falls steeply and late, behind a sampled loop that makes it grow: beside the poles of the
// mechanism under its friction at once, counts of roots are open, and the growth is known nevertheless.
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace stickslip;

namespace {

constexpr double motor = 2.2, link = 9, stiffness = 7e5, damping = 60, viscous = 30, k_v = 700;
constexpr double period = 1e-3, lag = 6 * period, V0 = 1.5e-3;
constexpr double c0 = 14, c1 = 35, c3 = 2e-3;

Joint steep_link(double k_p, double c2)
{
    Joint j;
    j.mechanism.motion = Motion::prismatic;
    j.mechanism.model = Model::two_mass;
    j.mechanism.motor_inertia = motor, j.mechanism.link_inertia = link;
    j.mechanism.transmission.stiffness = stiffness, j.mechanism.transmission.damping = damping;
    j.control.k_p = k_p, j.control.k_v = k_v, j.control.V0 = V0;
    j.control.period = j.control.delay = period;
    j.control.velocity_estimate.form = EstimateForm::backward_difference;
    j.frictions.motor.law = CoulombViscous{5, viscous};
    Stribeck curve;
    curve.c0 = c0, curve.c1 = c1, curve.c2 = c2, curve.c3 = c3;
    TimeLag delayed;
    delayed.lag = lag, delayed.curve.law = curve;
    j.frictions.link.law = delayed;
    return j;
}

/// The last four readings of a small motion of this loop, by Runge and Kutta's method of order 4.
std::array<double, 4> stepped_readings(double k_p, double c2, int ticks)
{
    using State = std::array<double, 4>;  // positions of motor and link, their velocities
    constexpr int parts = 200, late = 6 * parts;
    constexpr double h = period / parts;
    const double slope = c1 - c2 * 2 * V0 / (c3 * c3) * std::exp(-(V0 / c3) * (V0 / c3));
    std::vector<double> speed(late + 1, 0.0), readings;
    State y{1e-12, 0, 0, 0};
    double held = 0, command = 0, before = y[0];
    for (int tick = 0; tick < ticks; ++tick) {
        readings.push_back(y[0]);
        held = command;  // a tick late
        command = -(k_p * y[0] + k_v * (y[0] - before) / period);
        before = y[0];
        for (int i = 0; i < parts; ++i) {
            const auto at = speed.size() - 1 - late;
            const auto rate = [&](const State& s, double share) {
                const double v = (1 - share) * speed[at] + share * speed[at + 1];
                const double spring = stiffness * (s[0] - s[1]) + damping * (s[2] - s[3]);
                return State{s[2], s[3], (held - viscous * s[2] - spring) / motor, (spring - slope * v) / link};
            };
            const auto moved = [&](const State& by, double part) {
                State to = y;
                for (std::size_t k = 0; k < y.size(); ++k) to[k] += part * h * by[k];
                return to;
            };
            const State a = rate(y, 0), b = rate(moved(a, 0.5), 0.5), c = rate(moved(b, 0.5), 0.5),
                        d = rate(moved(c, 1), 1);
            for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
            speed.push_back(y[3]);
        }
    }
    std::array<double, 4> last;
    std::copy(readings.end() - 4, readings.end(), last.begin());
    return last;
}

/// One pair of modes outgrows all others, and three readings of it obey y_{k+2} = a y_{k+1} − |z|² y_k.
double stepped_growth(double k_p, double c2)
{
    constexpr int ticks = 160;
    const auto last = stepped_readings(k_p, c2, ticks);
    const double square = (last[2] * last[2] - last[1] * last[3]) / (last[1] * last[1] - last[0] * last[2]);
    return std::log(square) / 2 / period;
}

}  // namespace

TEST_CASE("A link whose friction falls steeply and late grows as its motion does")
{
    constexpr double c2 = 8;
    for (const double k_p : {2e6, 2.05e6, 2.06e6, 2.15e6}) {
        CAPTURE(k_p);
        const auto joint = steep_link(k_p, c2);
        const auto sliding = possible_sliding(joint);
        REQUIRE(sliding.reason == Reason::none);
        const double growth = real_growth(joint, false);
        CHECK(growth == Approx(stepped_growth(k_p, c2)).epsilon(1e-4));
        CHECK(real_root(joint).real() == growth);
    }
}

// Under this friction at once the link would grow by e^14, e^19 and e^42 within a tick; late it grows by less than e^1,
// along one real mode. The next one fades beside it by 60/s.
TEST_CASE("A link whose friction would leave no digit within a tick, were it prompt, grows as its motion does")
{
    constexpr double k_p = 2e6;
    constexpr int ticks = 320;
    for (const double c2 : {300.0, 400.0, 885.0}) {
        CAPTURE(c2);
        const auto joint = steep_link(k_p, c2);
        const auto sliding = possible_sliding(joint);
        REQUIRE(sliding.reason == Reason::none);
        const auto last = stepped_readings(k_p, c2, ticks);
        const double growth = real_growth(joint, false);
        CHECK(growth == Approx(std::log(last[3] / last[2]) / period).epsilon(1e-4));
        CHECK(linear_point(joint).reason == Reason::none);
        CHECK(real_side(joint, false) > 0);
    }
}
