// Sampled loops that no small matrix holds: many ticks of dead time, and delayed friction. Against the matrix
// of the same loop with its commands in it, and against motions stepped tick by tick.
#include "analysis/friction/time_lag.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/real_response.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/oracles/matrices.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <deque>

using namespace stickslip;

namespace {

LoopPlant mass_with_memory(double mass)
{
    // one state: rate −100, reference joint at 1 mm/s
    LoopPlant plant;
    plant.A = Eigen::MatrixXd::Zero(3, 3);
    plant.A << 0, 1, 0, 0, -1000 / mass, -1 / mass, 0, -1.5e5, -100;
    plant.B = Eigen::Vector3d(0, 1 / mass, 0);
    plant.C = Eigen::RowVector3d(1, 0, 0);
    plant.C_v = Eigen::RowVector3d(0, 1, 0);
    return plant;
}

/// m = 1 under f_v v − g v(t − τ) and a sampled PD loop, by classical Runge-Kutta steps with the past of v interpolated
/// to fourth order at half steps; ln|z|/T from the recurrence that its last readings obey.
double stepped_growth(double damping, double weight, double lag, double k_p, double k_v, double T, int dead, int parts)
{
    const double h = T / parts;
    const auto back = static_cast<std::size_t>(std::lround(lag / h));
    std::deque<double> past(back + 4, 0.0);  // v at the steps, newest last
    std::deque<double> line(static_cast<std::size_t>(dead) + 1, 0.0);
    double x = 0, v = 1, before = 0;
    past.back() = v;
    std::vector<double> readings;
    constexpr int ticks = 4000;
    for (int k = 0; k < ticks; ++k) {
        readings.push_back(x);
        line.push_back(-(k_p * x + k_v * (x - before) / T));
        line.pop_front();
        before = x;
        const double u = line.front();
        for (int i = 0; i < parts; ++i) {
            const auto at = [&](std::size_t ago) { return past[past.size() - 1 - ago]; };
            const double now = at(back), next = at(back - 1);
            const double half = (-at(back + 1) + 9 * now + 9 * next - at(back - 2)) / 16;
            const auto a = [&](double speed, double delayed) { return u - damping * speed + weight * delayed; };
            const double k1 = a(v, now), k2 = a(v + h / 2 * k1, half), k3 = a(v + h / 2 * k2, half),
                         k4 = a(v + h * k3, next);
            x += h * v + h * h / 6 * (k1 + k2 + k3);
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            past.push_back(v), past.pop_front();
        }
        const double size = std::abs(x) + std::abs(v);
        if (size < 1e-100 || size > 1e100) break;
    }
    const std::size_t n = readings.size();
    Eigen::MatrixXd A(400, 2);
    Eigen::VectorXd b(400);
    const double unit = std::abs(readings[n - 1]);
    for (std::size_t i = 0; i < 400; ++i) {
        const std::size_t k = n - 402 + i;
        A.row(static_cast<Eigen::Index>(i)) << readings[k + 1] / unit, readings[k] / unit;
        b[static_cast<Eigen::Index>(i)] = readings[k + 2] / unit;
    }
    const Eigen::Vector2d c = A.colPivHouseholderQr().solve(b);
    const std::complex<double> root = std::sqrt(std::complex<double>(c[0] * c[0] + 4 * c[1]));
    return std::log(std::max(std::abs(c[0] + root), std::abs(c[0] - root)) / 2) / T;
}

Joint lagging(double slope, double lag, double k_p, double k_v)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = k_p;
    joint.control.k_v = k_v;
    joint.control.V0 = 1e-2;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    TimeLag law;
    law.lag = lag;
    law.curve.law = Stribeck{20, slope, 0, 1, 2};
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("Dead time aside gives the multipliers and windows of the matrix that holds it")
{
    const auto plant = mass_with_memory(1);
    for (const double ticks : {3.0, 12.4, 60.0})
        for (const double tau : {0.0, 3e-3})
            for (const bool integrates : {false, true}) {
                const LoopTiming timing{1e-3, ticks * 1e-3, tau, 2, false};
                const LoopGains base{0, 300, integrates ? 2e4 : 0, 0}, turned{1, 0, 0, 0};
                const auto whole = discrete_loop(plant, timing, base, turned);
                const auto aside = delayed_sampled_loop({plant, {}, {}}, timing, 0, base, turned);
                REQUIRE(aside);
                INFO("ticks " << ticks << " tau " << tau << " integral " << integrates);
                for (const double k_p : {100.0, 3e3, 6e4}) {
                    const double growth = sampled_growth(whole, k_p);
                    CHECK(delayed_growth(*aside, k_p) == Approx(growth).epsilon(1e-9));
                }
                const auto circle = circle_crossings(whole);
                auto axis = axis_crossings(*aside);
                REQUIRE(axis.crossings.size() == circle.crossings.size());
                for (std::size_t i = 0; i < axis.crossings.size(); ++i) {
                    CHECK(axis.crossings[i].k_p == Approx(circle.crossings[i].k_p).epsilon(1e-8));
                    CHECK(axis.crossings[i].omega == Approx(circle.crossings[i].omega).epsilon(1e-8));
                    CHECK(axis.crossings[i].direction == circle.crossings[i].direction);
                }
                const auto by_circle = stable_gains(whole, circle.crossings, 3e3);
                const auto by_axis = stable_gains(*aside, axis, 3e3);
                REQUIRE(by_axis.size() == by_circle.size());
                for (std::size_t i = 0; i < by_axis.size(); ++i) {
                    CHECK(by_axis[i].low == Approx(by_circle[i].low).epsilon(1e-8));
                    CHECK(by_axis[i].high == Approx(by_circle[i].high).epsilon(1e-8));
                }
            }
}

TEST_CASE("Behind a second of dead time a joint grows as without its loop")
{
    const auto plant = mass_with_memory(1);
    const double alone = test::spectral_abscissa(plant.A);
    REQUIRE(alone > 10);
    const auto loop = delayed_sampled_loop({plant, {}, {}}, {1e-3, 1, 0, 1, false}, 0, {}, {6e4, 10, 0, 0});
    REQUIRE(loop);
    CHECK(delayed_growth(*loop, 1) == Approx(alone).epsilon(1e-8));
}

TEST_CASE("A sampled loop around friction that is delayed grows as its motion does")
{
    std::size_t windows = 0;
    struct Case {
        double slope, lag, k_p, k_v, delay;
    };
    for (const Case c : {Case{-60, 4e-3, 2e4, 80, 0}, Case{-60, 4e-3, 3e5, 30, 1e-3}, Case{40, 5.5e-3, 3e4, 0, 0},
                         Case{-30, 0.5e-3, 5e3, 50, 2e-3}}) {
        Joint joint = lagging(c.slope, c.lag, c.k_p, c.k_v);
        joint.control.delay = c.delay;
        const auto verdict = linear_verdict(joint);
        INFO("slope " << c.slope << " lag " << c.lag << " k_p " << c.k_p << " delay " << c.delay);
        REQUIRE(verdict.steady.reason == Reason::none);
        const int dead = static_cast<int>(std::lround(c.delay / 1e-3));
        const auto stepped = [&](double k_p) {
            return stepped_growth(0, -c.slope, c.lag, k_p, c.k_v, 1e-3, dead, 200);
        };
        const auto& memory = verdict.state_variable;
        CHECK(memory.spectral_abscissa == Approx(stepped(c.k_p)).epsilon(1e-6).margin(1e-6));
        windows += memory.stable_intervals.size();
        for (const auto& window : memory.stable_intervals)
            for (const double end : {window.low, window.high})
                if (end > 0 && end < memory.searched_to) CHECK(std::abs(stepped(end)) < 1e-4);
        REQUIRE(!memory.multipliers.empty());
        CHECK(std::log(std::abs(memory.multipliers[0])) / 1e-3 == Approx(memory.spectral_abscissa).epsilon(1e-9));
    }
    CHECK(windows >= 3);
}

TEST_CASE("A loop of 100 Hz around friction that falls steeply and late is judged, however fast it grows")
{
    // −72 N·s/m against steps in time, −7 kN·s/m on 1 kg grows many times over within a tick
    Joint joint = lagging(-72, 3e-3, 400, 20);
    joint.control.period = 1e-2;
    const double grows = stepped_growth(0, 72, 3e-3, 400, 20, 1e-2, 0, 300);
    REQUIRE(grows > 10);
    CHECK(growth_rate(joint) == Approx(grows).epsilon(1e-6));
    CHECK(real_side(joint, false) > 0);
    for (const double slope : {-700.0, -7e3}) {
        const Joint steep = [&] {
            Joint j = lagging(slope, 3e-3, 400, 20);
            j.control.period = 1e-2;
            return j;
        }();
        INFO("slope " << slope);
        CHECK(real_side(steep, false) > 0);
    }
}

TEST_CASE("Roots of delays at a few nodes lie beside those of the loop")
{
    for (const double slope : {-300.0, -30.0, 40.0})
        for (const double lag : {0.5e-3, 4e-3, 9e-3})
            for (const double delay : {0.0, 1.4e-3}) {
                Joint joint = lagging(slope, lag, 2e4, 80);
                joint.control.delay = delay;
                const auto loop = real_loop(joint, linear_joint(joint, 1e-2), 1e-2, TurnedGain::all);
                REQUIRE(loop);
                const auto* delayed = std::get_if<DelayedLoop>(&loop->loop);
                REQUIRE(delayed);
                const auto rough = rough_roots(*delayed, loop->gain);
                const auto exact = rightmost_root(*delayed, loop->gain);
                INFO("slope " << slope << " lag " << lag << " delay " << delay);
                REQUIRE(!rough.empty());
                REQUIRE(exact);
                CHECK(std::abs(rough.front() - *exact) < 0.03 * std::abs(*exact));
            }
}

TEST_CASE("A short period gives the continuous loop around late friction")
{
    Joint joint = lagging(-60, 5e-3, 1e5, 20);
    joint.control.delay = 1e-3;
    const double ticked = [&] {
        const auto at = [&](double T) {
            joint.control.period = T;
            return growth_rate(joint);
        };
        return 2 * at(1e-5) - at(2e-5);
    }();
    joint.control.period = not_set;
    const double continuous = growth_rate(joint);
    CHECK(std::isfinite(continuous));
    CHECK(ticked == Approx(continuous).epsilon(1e-5));
    // and the continuous loop, its delay taken away, is the ideal one
    joint.control.delay = 0;
    const double ideal = growth_rate(joint);
    const auto lagged = [&](double lag) {
        joint.actuator.lag = lag;
        return growth_rate(joint);
    };
    CHECK(2 * lagged(1e-7) - lagged(2e-7) == Approx(ideal).epsilon(1e-6));
}

TEST_CASE("Real loops around late friction and with long dead time answer forces")
{
    Joint joint = lagging(-30, 5e-3, 4e4, 120);
    joint.control.period = not_set;
    joint.control.delay = 1e-3;
    const auto delayed = LoopResponse::of(joint, Theory::state_variable);
    REQUIRE(delayed);
    for (const double omega : {3.0, 150.0, 900.0}) {
        const std::complex<double> s(0, omega);
        const auto F = s * s + (4e4 + 120.0 * s) * std::exp(-s * 1e-3) - 30.0 * s * std::exp(-s * 5e-3);
        CHECK(std::abs(delayed->at(omega) * F - 1.0) < 1e-11);
    }
    // the same loop with as many ticks of dead time as a matrix holds, and with one more
    joint = lagging(-30, 5e-3, 200, 30);
    joint.friction.law = CoulombViscous{20, 5};
    for (const double ticks : {39.0, 45.0}) {
        joint.control.delay = ticks * 1e-3;
        const auto response = LoopResponse::of(joint, Theory::state_variable);
        REQUIRE(response);
        SampledForce force{1e-3, std::vector<double>(300, 1.0), 0};
        const auto moved = response->forced(force);
        double x = 0, v = 0, before = 0;
        std::deque<double> line(static_cast<std::size_t>(ticks) + 1, 0.0);
        for (std::size_t k = 0; k < 300; ++k) {
            CHECK(moved.position[k] == Approx(x).epsilon(1e-9).margin(1e-12));
            line.push_back(-(200 * x + 30 * (x - before) / 1e-3));
            line.pop_front();
            before = x;
            const double push = 1 + line.front(), left = std::exp(-5e-3), end = push / 5;
            x += end * 1e-3 + (v - end) * (1 - left) / 5;
            v = end + (v - end) * left;
        }
    }
}

TEST_CASE("The motion of a loop with many ticks of dead time grows as its roots say", "[slow]")
{
    for (const double ticks : {70.0, 250.4}) {
        Joint joint = example_joint(60e3, 10, 1e-3);
        joint.control.velocity_estimate.form = EstimateForm::backward_difference;
        joint.control.period = 1e-3;
        joint.control.delay = ticks * 1e-3;
        const double theory = growth_rate(joint);
        LoopQuestion question;
        question.region = false;
        const auto verdict = loop_verdict(joint, question);
        INFO("ticks " << ticks);
        CHECK(std::log(std::abs(verdict.multiplier)) / 1e-3 == Approx(theory).epsilon(1e-5));
        CHECK(verdict.growth_rate == Approx(theory).epsilon(1e-5));
    }
}

TEST_CASE("No window contains a gain that grows, however short the dead time")
{
    LoopPlant fed;  // a mass that friction feeds
    fed.A = Eigen::MatrixXd::Zero(2, 2);
    fed.A << 0, 1, 0, 0.5;
    fed.B = Eigen::Vector2d(0, 1);
    fed.C = Eigen::RowVector2d(1, 0);
    fed.C_v = Eigen::RowVector2d(0, 1);
    const auto loop = delayed_loop({fed, {}, {}}, 1e-9, 0, 0, {}, {1, 0, 0, 0});
    REQUIRE(delayed_growth(loop, 1e3) == Approx(0.25).epsilon(1e-3));
    auto crossings = axis_crossings(loop);
    REQUIRE(crossings.crossings.size() > 12);
    CHECK(stable_gains(loop, crossings, 1e3).empty());
}

TEST_CASE("What is added to a command of a sampled loop around late friction is answered as a motion stepped in time")
{
    constexpr double lag = 2.4e-3, T = 1e-3, slope = -30, k_p = 4e4, k_v = 120;
    constexpr int parts = 400, lag_parts = 960, ticks = 1500;
    const Joint joint = lagging(slope, lag, k_p, k_v);
    CHECK_FALSE(LoopResponse::of(joint, Theory::state_variable));  // of forces between ticks there is no map
    const auto response = LoopResponse::of(joint, Theory::state_variable, LoopResponse::Input::command);
    REQUIRE(response);
    REQUIRE(response->growth() < 0);
    // one newton more in the first command; the late speed by the trapezoidal rule
    constexpr double h = T / parts;
    std::vector<double> at_ticks, commands;
    std::deque<double> past(lag_parts + 1, 0.0);  // speeds from now back to a lag ago
    double x = 0, v = 0, before = 0;
    for (int k = 0; k < ticks; ++k) {
        const double u = (k == 0 ? 1 : 0) - k_p * x - k_v * (x - before) / T;
        before = x;
        at_ticks.push_back(x), commands.push_back(u);
        for (int i = 0; i < parts; ++i) {
            const double delayed = 0.5 * (past[lag_parts] + past[lag_parts - 1]);
            const double next = v + h * (u - slope * delayed);
            x += 0.5 * h * (v + next);
            v = next;
            past.push_front(v), past.pop_back();
        }
    }
    for (const double omega : {3.0, 150.0, 240.0, 2000.0}) {
        std::complex<double> moved = 0, commanded = 0;
        for (int k = 0; k < ticks; ++k) {
            const auto turn = std::polar(1.0, -omega * T * k);
            moved += at_ticks[static_cast<std::size_t>(k)] * turn;
            commanded += commands[static_cast<std::size_t>(k)] * turn;
        }
        CHECK(std::abs(response->by_command(omega).motion / moved - 1.0) < 1e-5);
        CHECK(std::abs(response->by_command(omega).remains / commanded - 1.0) < 1e-5);
    }
}
