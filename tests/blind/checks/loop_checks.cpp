// The sampled loop against its definition, and against a second, cruder integration of the same equations.
#include "tests/blind/checks/machines.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace blind;

namespace {

double standard_deviation(const std::vector<double>& x)
{
    double mean = 0, square = 0;
    for (double v : x) mean += v / x.size();
    for (double v : x) square += (v - mean) * (v - mean) / x.size();
    return std::sqrt(square);
}

}  // namespace

TEST_CASE("tiny fixed steps with a different stick rule give the same motion", "[blind]")
{
    const Machine m = servo();
    const Excitation e = sine(0.8, 0.4, 4);
    const Record r = run_loop(m, e, 1);
    // Explicit Euler at 2 µs; friction is whatever stops the body within the step, up to its level.
    const int per_sample = 500;
    const double h = m.controller.period / per_sample;
    double q = 0, v = 0, last = 0, worst = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        worst = std::max(worst, std::abs(q - r.position[k]));
        const double estimate = k ? (q - last) / m.controller.period : 0;
        const Reference ref = e.at(k * m.controller.period);
        const double u = m.controller.k_p * (ref.position - q) + m.controller.k_v * (ref.velocity - estimate);
        last = q;
        for (int i = 0; i < per_sample; ++i) {
            const double wanted = v + h / 0.1 * (u - 0.2 * v), hold = h / 0.1 * 0.5;
            const double next = std::abs(wanted) <= hold ? 0 : wanted - std::copysign(hold, wanted);
            q += 0.5 * h * (v + next);
            v = next;
        }
    }
    INFO("largest difference " << worst);
    CHECK(worst < 2e-5);
}

TEST_CASE("the logged columns reproduce velocity and command by the stated recursion", "[blind]")
{
    Machine m = servo();
    m.sensors = {.quantum = 1e-3, .position_noise = 4e-4, .effort_noise = 0.01};
    m.controller.filter = 3e-3;
    for (bool reference_velocity : {true, false}) {
        m.controller.reference_velocity = reference_velocity;
        m.controller.limit = 8;
        const Record r = run_loop(m, sine(0.8, 0.7, 3), 5);
        const double T = m.controller.period;
        double v = 0, worst = 0;
        for (std::size_t k = 0; k < r.size(); ++k) {
            if (k > 0) v += T / (m.controller.filter + T) * ((r.position[k] - r.position[k - 1]) / T - v);
            const double rate = reference_velocity ? r.reference_velocity[k] : 0;
            const double u =
                m.controller.k_p * (r.reference_position[k] - r.position[k]) + m.controller.k_v * (rate - v);
            worst = std::max({worst, std::abs(std::clamp(u, -8.0, 8.0) - r.command[k]), std::abs(v - r.velocity[k])});
        }
        CHECK(worst < 1e-11);
    }
}

TEST_CASE("a cascade gives the commands of the sum of gains that it is, until a dead zone parts them", "[blind]")
{
    // K_v (K (r − y) + ṙ − v) + K_i Σ T (…): k_p = K_v K + K_i, k_i = K_i K where Σ T v is the way that was read
    Machine cascade = servo(), sum = servo();
    cascade.controller.cascade = true;
    cascade.controller.position_gain = 15, cascade.controller.velocity_gain = 4,
    cascade.controller.velocity_integral = 10;
    sum.controller.k_p = 4 * 15 + 10, sum.controller.k_v = 4, sum.controller.k_i = 10 * 15;
    for (Machine* m : {&cascade, &sum}) m->controller.coulomb = 0.2, m->controller.coulomb_speed = 0.05;
    const auto e = sine(0.8, 0.7, 3);
    const auto differ = [&] {
        const Record a = run_loop(cascade, e, 1), b = run_loop(sum, e, 1);
        double worst = 0, size = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            worst = std::max(worst, std::abs(a.command[k] - b.command[k]));
            size = std::max(size, std::abs(b.command[k]));
        }
        return worst / size;
    };
    // the sums of the cascade are rectangles of the reference's rate, the other's have its positions
    CHECK(differ() < 5e-3);
    cascade.controller.dead_zone = 0.05;
    CHECK(differ() > 0.1);
}

TEST_CASE("noise is as large as stated and readings lie on the encoder's grid", "[blind]")
{
    Machine m = servo();
    m.sensors = {.quantum = 2e-4, .position_noise = 1e-4, .effort_noise = 0.02};
    const Record r = run_loop(m, sine(0.8, 0.4, 20), 11);
    std::vector<double> position_error, effort_error;
    double off_grid = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        position_error.push_back(r.position[k] - r.true_position[k]);
        effort_error.push_back(r.effort[k] - r.command[k]);
        const double steps = r.position[k] / 2e-4;
        off_grid = std::max(off_grid, std::abs(steps - std::round(steps)));
    }
    CHECK(off_grid < 1e-9);
    CHECK(standard_deviation(position_error) == Approx(std::sqrt(1e-8 + 4e-8 / 12)).epsilon(0.03));
    CHECK(standard_deviation(effort_error) == Approx(0.02).epsilon(0.03));
}

TEST_CASE("dead time, lag, gain and limit act in that order", "[blind]")
{
    Machine m = servo();
    m.drive.dead_time = 3e-3;
    m.drive.gain = 0.9;
    const Excitation e = sine(0.5, 0.6, 2);
    Record r = run_loop(m, e, 1);
    for (std::size_t k = 3; k < r.size(); k += 37) CHECK(r.effort[k] == Approx(0.9 * r.command[k - 3]));
    CHECK(r.effort[2] == 0);

    m.drive.lag = 4e-3;
    m.drive.limit = 0.8;
    r = run_loop(m, e, 1);
    const double keep = std::exp(-1e-3 / 4e-3);
    double lagged = 0, worst = 0;
    bool limited = false;
    for (std::size_t k = 3; k < r.size(); ++k) {
        if (k > 3) lagged = r.command[k - 4] + keep * (lagged - r.command[k - 4]);
        const double effort = std::clamp(0.9 * lagged, -0.8, 0.8);
        limited = limited || std::abs(effort) == 0.8;
        worst = std::max(worst, std::abs(effort - r.effort[k]));
    }
    CHECK(limited);
    CHECK(worst < 1e-9);
}

TEST_CASE("a dead time between two samples acts between them", "[blind]")
{
    Machine whole = servo(), half = servo(), next = servo();
    whole.drive.dead_time = 2e-3;
    half.drive.dead_time = 2.5e-3;
    next.drive.dead_time = 3e-3;
    const Excitation e = sine(0.5, 0.6, 3);
    const Record a = run_loop(whole, e, 1), b = run_loop(half, e, 1), c = run_loop(next, e, 1);
    double middle = 0, span = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        middle = std::max(middle, std::abs(b.position[k] - 0.5 * (a.position[k] + c.position[k])));
        span = std::max(span, std::abs(c.position[k] - a.position[k]));
    }
    CHECK(middle < 0.05 * span);
}

TEST_CASE("rate-and-state friction weakens by (A − B) ln of the velocity ratio, Coulomb friction does not", "[blind]")
{
    Machine m = servo();
    const double A = 0.01, B = 0.03;
    const auto effort_at = [&](double velocity) {
        const Record r = run_loop(m, ramp(velocity, 6), 1);
        return r.effort.back() - 0.2 * velocity;
    };
    CHECK(effort_at(0.3) == Approx(0.5).epsilon(1e-4));
    m.mechanism.friction[0].direct = A;
    m.mechanism.friction[0].evolution = B;
    m.mechanism.friction[0].slip_length = 0.01;
    m.mechanism.friction[0].slip_velocity = 0.1;
    CHECK(effort_at(0.3) == Approx(0.5 + (A - B) * std::log(3)).epsilon(1e-3));
    CHECK(effort_at(0.6) - effort_at(0.3) == Approx((A - B) * std::log(2)).epsilon(5e-3));
}

TEST_CASE("the two directions differ by twice the asymmetry, an encoder offset shifts gravity's phase", "[blind]")
{
    Machine m = servo();
    m.mechanism.friction[0].uneven_coulomb = 0.1;
    const auto effort_at = [](const Machine& machine, double velocity) {
        return run_loop(machine, ramp(velocity, 4), 1).effort.back();
    };
    CHECK(effort_at(m, 0.3) + effort_at(m, -0.3) == Approx(2 * 0.1).epsilon(1e-3));

    Machine tilted = servo(), offset = servo();
    tilted.mechanism.gravity = offset.mechanism.gravity = 2;
    tilted.mechanism.gravity_phase = -0.2;
    offset.sensors.offset = 0.2;
    const Record a = run_loop(tilted, sine(0.7, 0.5, 3), 1), b = run_loop(offset, sine(0.7, 0.5, 3), 1);
    for (std::size_t k = 0; k < a.size(); k += 101) CHECK(a.position[k] == Approx(b.position[k]).margin(1e-7));
}
