// The sampled loop as it moves: cycles against told numbers and against an integrator of another kind, growth against a
// monodromy that is put together here.
#include <catch2/catch.hpp>

#include "analysis/joint/gains.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/sampled/loop_record.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/oracles/matrices.h"

#include <Eigen/Dense>

#include <deque>

using namespace stickslip;

namespace {

/// ln max|z| / T of ticked_joint with whole ticks of dead time: the matrix exponential of mechanism and hold, then the
/// difference of readings.
double growth_of(double k_p, int dead_ticks, double contact = 0)
{
    const double m = 1, A = 1, B = 1.5, L = 1e-5, V = 1e-3, k_v = 10, T = 1e-3;
    // x, v, θ and the held force
    Eigen::Matrix4d F = Eigen::Matrix4d::Zero();
    F(0, 1) = 1;
    F(1, 0) = -contact / m, F(1, 1) = -A / V / m, F(1, 2) = -1 / m, F(1, 3) = 1 / m;
    F(2, 1) = -B / L, F(2, 2) = -V / L;
    const Eigen::Matrix4d step = test::exponential(F * T);
    // and the last reading, and commands on their way, newest first
    const int n = 4 + dead_ticks;
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
    Eigen::RowVectorXd command = Eigen::RowVectorXd::Zero(n);
    command(0) = -k_p - k_v / T, command(3) = k_v / T;
    Eigen::RowVectorXd arriving = command;
    if (dead_ticks > 0) arriving = Eigen::RowVectorXd::Unit(n, n - 1);
    M.topLeftCorner(3, 3) = step.topLeftCorner(3, 3);
    M.topRows(3) += step.topRightCorner(3, 1) * arriving;
    M(3, 0) = 1;
    for (int i = 0; i < dead_ticks; ++i) M.row(4 + i) = i == 0 ? command : Eigen::RowVectorXd::Unit(n, 3 + i);
    return static_cast<double>(std::log(test::spectral_radius(test::LongMatrix(M.cast<long double>())))) / T;
}

/// Half peak to peak of the joint's motion under Runge and Kutta's method in x, V and θ, 100 steps a tick.
double amplitude_by_runge_kutta(double k_p, int dead_ticks, double seconds, double contact = 0)
{
    using State = Eigen::Vector3d;
    const double V0 = 1e-3, T = 1e-3;
    double u = 60;
    const double slides_at = -60 / k_p;
    const auto rate = [&](const State& y) {
        const double log = std::log(y[1] / 1e-3);
        return State(y[1] - V0, u - contact * (y[0] - slides_at) - (60 + log + y[2]),
                     -y[1] / 1e-5 * (y[2] + 1.5 * log));
    };
    State y(slides_at, 1.2e-3, 0);
    std::deque<double> delayed(static_cast<std::size_t>(dead_ticks), 60.0);
    double before = y[0], low = 1, high = -1;
    for (int k = 0; k < static_cast<int>(seconds / T); ++k) {
        delayed.push_back(-k_p * y[0] - 10 * (y[0] - before) / T);
        before = y[0];
        u = delayed.front();
        delayed.pop_front();
        for (int i = 0; i < 100; ++i) {
            const double h = T / 100;
            const State a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b), d = rate(y + h * c);
            y += h / 6 * (a + 2 * b + 2 * c + d);
            if (k * T > 0.6 * seconds) low = std::min(low, y[0]), high = std::max(high, y[0]);
        }
    }
    return 0.5 * (high - low);
}

}  // namespace

TEST_CASE("sampled loop: the reference design is stick-slip at 1 kHz with one tick of dead time", "[sampled]")
{
    const auto delayed = nonlinear_verdict(ticked_joint(60e3, 1e-3), {});
    CHECK(delayed.outcome == Outcome::limit_cycle);
    CHECK(delayed.region == NonlinearRegion::stick_slip);
    CHECK(delayed.path == DecisionPath::ticks);
    CHECK(delayed.amplitude == Approx(18.1688e-6).epsilon(2e-5));
    CHECK(delayed.period == Approx(96.615e-3).epsilon(1e-5));
    CHECK(std::log(delayed.velocity_min / 1e-3) == Approx(-1.13878).margin(2e-5));
    CHECK(std::log(delayed.velocity_max / 1e-3) == Approx(1.27205).margin(2e-5));
    const auto prompt = nonlinear_verdict(ticked_joint(50e3), {});
    CHECK(prompt.amplitude == Approx(22.1829e-6).epsilon(1e-5));
    CHECK(prompt.period == Approx(109.448e-3).epsilon(1e-5));
    const auto stiff = nonlinear_verdict(ticked_joint(67e3, 1e-3), {});
    CHECK(stiff.outcome == Outcome::stable_sliding);
    CHECK(stiff.region == NonlinearRegion::stable);
    CHECK(stiff.growth_rate < 0);
}

TEST_CASE("sampled loop: small motions grow at the rate of the multipliers", "[sampled][slow]")
{
    for (const int dead_ticks : {0, 1, 3})
        for (const double k_p : {40e3, 60e3, 90e3}) {
            const auto verdict = loop_verdict(ticked_joint(k_p, dead_ticks * 1e-3), {.region = false});
            INFO("k_p " << k_p << ", dead ticks " << dead_ticks);
            const double told = growth_of(k_p, dead_ticks);
            CHECK(verdict.growth_rate == Approx(told).epsilon(1e-5));
            CHECK(std::log(std::abs(verdict.multiplier)) / verdict.tick == Approx(told).epsilon(1e-5));
        }
}

TEST_CASE("sampled loop: a spring to the surroundings bears nothing while the joint slides steadily", "[sampled]")
{
    const double contact = 8e3;
    for (const double k_p : {40e3, 60e3}) {
        Joint joint = ticked_joint(k_p, 1e-3);
        joint.control.contact_stiffness = contact;
        const auto verdict = nonlinear_verdict(joint, {});
        INFO("k_p " << k_p);
        CHECK(verdict.growth_rate == Approx(growth_of(k_p, 1, contact)).epsilon(1e-5));
        CHECK(verdict.growth_rate != Approx(growth_of(k_p, 1)).epsilon(1e-2));
        REQUIRE(verdict.region == (verdict.growth_rate > 0 ? NonlinearRegion::stick_slip : NonlinearRegion::stable));
        if (verdict.growth_rate > 0)
            CHECK(verdict.amplitude == Approx(amplitude_by_runge_kutta(k_p, 1, 4, contact)).epsilon(1e-3));
    }
    for (const Model model : {Model::two_mass, Model::three_mass}) {
        Joint joint = ticked_joint(40e3, 1e-3);
        auto& m = joint.mechanism;
        m.model = model, m.motor_inertia = 0.3, m.transmission_inertia = 0.3, m.link_inertia = 0.4;
        for (auto* spring : {&m.transmission, &m.motor_transmission, &m.transmission_link})
            spring->stiffness = 3e5, spring->damping = 40;
        joint.frictions.motor.law = joint.frictions.transmission.law = CoulombViscous{.coulomb = 5, .viscous = 20};
        joint.frictions.link = joint.friction;
        joint.control.contact_stiffness = contact;
        const auto verdict = loop_verdict(joint, {.region = false});
        INFO("masses " << (model == Model::two_mass ? 2 : 3));
        CHECK(verdict.growth_rate == Approx(real_growth(joint, false)).epsilon(1e-4));
    }
}

TEST_CASE("sampled loop: turns that alternate are a motion of period two", "[sampled][slow]")
{
    // by Dormand and Prince's method in every tick: peaks of 5.46 and 20.2 micrometres, 26 and 36 ticks apart
    const auto verdict = nonlinear_verdict(ticked_joint(402.7e3, 4e-3), {});
    CHECK(verdict.outcome == Outcome::period_n);
    CHECK(verdict.repeats == 2);
    CHECK(verdict.period == Approx(61.4e-3).epsilon(5e-3));
}

TEST_CASE("sampled loop: elements of friction that slip at their yield force take no part in small motions",
          "[sampled]")
{
    MaxwellSlip law;
    law.elements.push_back({29419, 0.368});
    law.elements.push_back({326, 0.19});
    law.viscous = 0.95;
    Joint joint = ticked_joint(1e4);
    joint.mechanism.inertia = 0.5, joint.control.k_v = 20, joint.control.V0 = 0.0144;
    joint.friction.law = law;
    const auto sampled = loop_verdict(joint, {});
    CHECK(sampled.growth_rate == Approx(real_growth(joint, false)).epsilon(1e-5));
    CHECK(sampled.region == NonlinearRegion::stable);
    joint.control.period = not_set, joint.control.velocity_estimate = {}, joint.actuator.effort_gain = 2;
    const auto amplified = loop_verdict(joint, {});  // −(2 k_v + viscous)/2m
    CHECK(amplified.growth_rate == Approx(-40.95).epsilon(1e-3));
    CHECK(amplified.region == NonlinearRegion::stable);
}

TEST_CASE("sampled loop: a joint whose rates leave no time step is refused in words", "[sampled]")
{
    Joint joint = ticked_joint(1e300);
    joint.control.period = not_set, joint.control.velocity_estimate = {}, joint.actuator.effort_gain = 2;
    joint.mechanism.inertia = 1e-300;
    const auto verdict = loop_verdict(joint, {});
    CHECK(verdict.reason == Reason::not_finite);
    CHECK(verdict.detail == Detail::no_time_step);
}

TEST_CASE("sampled loop: cycles are those of another integrator", "[sampled][slow]")
{
    for (const auto& [k_p, dead_ticks] : {std::pair{45e3, 0}, {58e3, 1}, {62e3, 2}}) {
        const auto verdict = loop_verdict(ticked_joint(k_p, dead_ticks * 1e-3), {.region = false});
        INFO("k_p " << k_p << ", dead ticks " << dead_ticks);
        CHECK(verdict.cycle.amplitude == Approx(amplitude_by_runge_kutta(k_p, dead_ticks, 20)).epsilon(1e-4));
    }
}

TEST_CASE("sampled loop: a cascade is the sum of gains that it comes to", "[sampled]")
{
    Joint sum = ticked_joint(60e3, 1e-3), cascade = sum;
    sum.control.k_v = 40, sum.control.k_i = 2e5;
    // K_v K_pos + K_i = 60e3, K_i K_pos = 2e5, K_v = 40
    auto& c = cascade.control;
    c.structure = Structure::cascade;
    c.velocity_gain = 40;
    c.position_gain = (60e3 - std::sqrt(60e3 * 60e3 - 4 * 40 * 2e5)) / 80;
    c.velocity_integral_gain = 60e3 - 40 * c.position_gain;
    c.k_p = c.k_v = not_set;
    const auto a = loop_verdict(sum, {.region = false}), b = loop_verdict(cascade, {.region = false});
    CHECK(a.growth_rate == Approx(b.growth_rate).epsilon(1e-5));  // what a measured growth holds, as above
    CHECK(a.cycle.amplitude == Approx(b.cycle.amplitude).epsilon(1e-5));
}

TEST_CASE("sampled loop: a cascade behind a filtered velocity grows at its own root, not at that of a sum of gains",
          "[sampled]")
{
    Joint cascade = ticked_joint(60e3);
    auto& c = cascade.control;
    c.structure = Structure::cascade;
    c.position_gain = 50, c.velocity_gain = 1200, c.velocity_integral_gain = 6e4;
    c.k_p = c.k_v = not_set;
    c.velocity_estimate.tau = 5e-3;
    TimeLag late;
    late.lag = 3e-3;
    late.curve.law = Stribeck{20, -100, 0, 1, 2};
    for (const bool lags : {false, true}) {
        if (lags) cascade.friction.law = late;  // its motion follows the root of the theory
        const double own = growth_rate(cascade), summed = growth_rate(with_gains(cascade));
        INFO("late friction " << lags << ", own " << own << ", sum of gains " << summed);
        REQUIRE(std::abs(own - summed) > 0.01 * std::abs(own));
        const LoopInquiry inquiry(cascade, {.region = false}, GrowthBy::theory);
        const auto& verdict = inquiry.verdict();
        CHECK(verdict.growth_rate == Approx(own).epsilon(1e-9));
    }
}

TEST_CASE("sampled loop: a limit below the friction of steady sliding is said", "[sampled]")
{
    Joint joint = ticked_joint(60e3);
    joint.control.effort_limit = 50;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::undecided);
    CHECK(verdict.reason == Reason::no_steady_state);
    CHECK(verdict.detail == Detail::effort_limit);
}

TEST_CASE("sampled loop: ticks that get shorter lead to the continuous loop, and that to the ideal one", "[sampled]")
{
    Joint continuous = ticked_joint(50e3);
    continuous.control.period = not_set;
    const auto ideal = nonlinear_verdict(continuous, {.region = false});
    continuous.actuator.lag = 1e-7;
    const auto nearly = loop_verdict(continuous, {.region = false});
    CHECK(nearly.cycle.amplitude == Approx(ideal.amplitude).epsilon(1e-3));
    CHECK(nearly.growth_rate == Approx(ideal.growth_rate).epsilon(1e-3));
}

TEST_CASE("sampled loop: a coarse encoder leaves a jitter of about its step", "[sampled]")
{
    Joint joint = ticked_joint(80e3, 1e-3);
    joint.sensor.encoder_quantum = 1e-7;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.jitter > 0.2e-7);
    CHECK(verdict.jitter < 5e-7);
    // which is no limit cycle: neither the verdict nor a map has one there
    CHECK(std::isnan(verdict.amplitude));
    PointResult point;
    write_nonlinear(verdict, point);
    CHECK(point.outcome == Outcome::stable_sliding);
    CHECK(std::isnan(point.amplitude));
}

TEST_CASE("sampled loop: a strain wave gear that creeps under an encoder and noise is decided", "[sampled][slow]")
{
    const auto soft = nonlinear_verdict(creeping_elbow(6e3, 200, 8.7e-5), {});
    CHECK(soft.outcome == Outcome::limit_cycle);
    CHECK(soft.region == NonlinearRegion::stick_slip);
    // the cycle of the same joint without encoder and noise, which turns tell
    Joint clean = creeping_elbow(6e3, 200, 8.7e-5);
    clean.sensor = {};
    NonlinearOptions longer;
    longer.effort = 10;
    CHECK(soft.amplitude == Approx(nonlinear_verdict(clean, longer).amplitude).epsilon(0.15));
    // beside the boundary a motion grows slowly out of the noise: 3.3e-6 rad over two minutes, 0.6e-6 in the first ten
    // seconds
    CHECK(nonlinear_verdict(creeping_elbow(10e3, 111.7, 8.7e-5), {}).amplitude == Approx(3.3e-6).epsilon(0.3));
    // the boundary lies at 8.38 kN·m/rad; from rest the motor is held by its contact at first
    for (const double k_p : {12e3, 30e3}) {
        const auto stiff = nonlinear_verdict(creeping_elbow(k_p, k_p / 60, 8.7e-5), {});
        CAPTURE(k_p, static_cast<int>(stiff.reason));
        CHECK(stiff.outcome == Outcome::stable_sliding);
        CHECK(stiff.region == NonlinearRegion::stable);
    }
}

TEST_CASE("sampled loop: a contact with hardly a direct effect moves as dry friction does", "[sampled]")
{
    Joint dry = ticked_joint(4e3);
    dry.control.k_v = 120;
    dry.friction.law = CoulombViscous{5, 10};
    Joint contact = dry;
    constexpr double direct_effect = 1e-3;  // times ln of all velocities between rest and motion: 0.03 N of 5 N
    SECTION("beside a law of its own")
    {
        auto& memory = contact.friction.memory;
        memory.A = direct_effect, memory.L = 1e-5;
    }
    SECTION("as the regularised law alone")
    {
        dry.friction.law = CoulombViscous{5, 0};
        RateAndStateRegularised law;
        law.f0 = 5, law.A = direct_effect, law.V_star = 1e-3;
        contact.friction.law = law;
    }
    ReferenceMotion reference;
    for (int k = 0; k <= 2000; ++k) {
        reference.time.push_back(1e-3 * k);
        reference.position.push_back(0.01 * (1 - std::cos(6e-3 * k)));
    }
    for (Joint* joint : {&dry, &contact}) joint->sensor.position_noise = 1e-7;
    const auto a = record_along(dry, reference, 3), b = record_along(contact, reference, 3);
    REQUIRE(a.time.size() == reference.time.size());
    REQUIRE(b.time.size() == reference.time.size());
    double apart = 0;
    for (std::size_t k = 0; k < a.position.size(); ++k)
        apart = std::max(apart, std::abs(a.position[k] - b.position[k]));
    CHECK(apart < 2 * 0.03 / 4e3);
}
