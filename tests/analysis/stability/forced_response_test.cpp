// Answers in time against closed forms of the damped oscillator and against |X/D|.
#include <catch2/catch.hpp>

#include "analysis/stability/forced_response.h"
#include "analysis/stability/loop_margins.h"
#include "analysis/stability/steady.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// m = 2 kg, damping 10 N·s/m, stiffness 5000 N/m: ω_0 = 50 rad/s, decay 2.5 1/s.
LinearJoint oscillator()
{
    LinearJoint j;
    j.inertia[0] = 2;
    j.actuated[0] = 1;
    j.k_p = 5000;
    j.k_v = 10;
    return j;
}
const double decay = 2.5, damped = std::sqrt(2500 - 2.5 * 2.5);

}  // namespace

TEST_CASE("impulse and step responses are those of the damped oscillator", "[stability]")
{
    const auto impulse = forced_response(oscillator(), sampled_force(ForceKind::impulse, 3, 1, 0.01));
    const auto step = forced_response(oscillator(), sampled_force(ForceKind::step, 7, 1, 0.01));
    REQUIRE(impulse.time.size() == 101);
    for (std::size_t i = 0; i <= 100; ++i) {
        const double t = 0.01 * i, e = std::exp(-decay * t);
        CHECK(impulse.time[i] == Approx(t));
        CHECK(impulse.position[i] == Approx(1.5 / damped * e * std::sin(damped * t)).margin(1e-14));
        const double free = e * (std::cos(damped * t) + decay / damped * std::sin(damped * t));
        CHECK(step.position[i] == Approx(7.0 / 5000 * (1 - free)).margin(1e-14));
    }
    CHECK(impulse.velocity[0] == 1.5);
}

TEST_CASE("after its transient a sine is answered with |X/D|(iω), in every kind of joint", "[stability]")
{
    Joint stiff = samples::two_mass();
    stiff.control.k_p = 2e5;
    stiff.control.k_v = 800;
    Joint one = samples::single_mass(1);
    one.control.k_p = 8e4;
    for (const auto& joint : {stiff, one}) {
        const auto linear = linear_joint(joint, commanded_velocity(joint));
        const double omega = 150;
        const auto answer = forced_response(linear, sampled_force(ForceKind::sine, 1, 4, 2e-5, omega));
        double largest = 0;
        for (std::size_t i = answer.time.size() * 3 / 4; i < answer.time.size(); ++i)
            largest = std::max(largest, std::abs(answer.position[i]));
        CHECK(largest == Approx(std::abs(disturbance_response(linear, {0, omega}))).epsilon(1e-4));
    }
}

TEST_CASE("noise has its standard deviation and is the same for the same seed", "[stability]")
{
    const auto a = sampled_force(ForceKind::noise, 2, 100, 0.01, 0, 7),
               b = sampled_force(ForceKind::noise, 2, 100, 0.01, 0, 7),
               c = sampled_force(ForceKind::noise, 2, 100, 0.01, 0, 8);
    CHECK(a.value == b.value);
    CHECK(a.value != c.value);
    double sum = 0, squares = 0;
    for (const double v : a.value) sum += v, squares += v * v;
    CHECK(sum / 1e4 == Approx(0).margin(0.08));                  // 4 standard errors of the mean
    CHECK(std::sqrt(squares / 1e4) == Approx(2).epsilon(0.03));  // and of the deviation
    CHECK_THROWS_AS(sampled_force(ForceKind::step, 1, 1, 0), std::invalid_argument);
}

TEST_CASE("delayed friction is answered by the method of steps", "[stability]")
{
    // before the first delay is over nothing has come back: the oscillator alone
    LinearJoint delayed = oscillator();
    delayed.friction[0].delays.push_back({100, 0.0503});
    const auto impulse = forced_response(delayed, sampled_force(ForceKind::impulse, 3, 0.1, 0.01));
    const auto alone = [](double t) { return 1.5 / damped * std::exp(-decay * t) * std::sin(damped * t); };
    for (int i = 0; i <= 5; ++i) CHECK(impulse.position[i] == Approx(alone(0.01 * i)).margin(1e-14));
    // between one delay and two the impulse response h is convolved with itself once: x = h + w ∫ h'(s) h(t − τ − s) m
    // ds
    const double t = 0.1, end = t - 0.0503;
    const int n = 2000;
    double sum = 0;
    for (int k = 0; k <= n; ++k) {  // Simpson
        const double s = end * k / n, e = std::exp(-decay * s) * 1.5;
        const double speed = e * (std::cos(damped * s) - decay / damped * std::sin(damped * s));
        sum += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * speed * alone(end - s) / 3;
    }
    CHECK(impulse.position[10] == Approx(alone(t) + 100 * sum * end / (3 * n)).epsilon(1e-6));
}

TEST_CASE("a table sampled from an exponential moves the joint as the state does", "[stability]")
{
    LinearJoint state = oscillator(), table = oscillator();
    auto& f = state.friction[0];
    f.states = 1, f.lambda[0] = -100, f.b[0] = 1, f.h[0] = -400;
    KernelTable g;
    for (int i = 0; i <= 400; ++i) g.time.push_back(i * 5e-4), g.value.push_back(400 * std::exp(-100 * g.time.back()));
    table.friction[0].table = std::make_shared<KernelTable>(g);
    for (const auto kind : {ForceKind::impulse, ForceKind::step, ForceKind::noise}) {
        const auto force = sampled_force(kind, 1, 0.3, 0.005);
        const auto a = forced_response(state, force), b = forced_response(table, force);
        double largest = 0, gap = 0;
        for (std::size_t i = 0; i < a.time.size(); ++i) {
            largest = std::max(largest, std::abs(a.position[i]));
            gap = std::max(gap, std::abs(a.position[i] - b.position[i]));
        }
        CHECK(gap < 2e-4 * largest);  // chords over an exponential: (100 · 5e-4)²/12 of it
    }
}

TEST_CASE("late friction answers a lasting sine with |X/D|(iω)", "[stability]")
{
    LinearJoint delayed = oscillator();
    delayed.k_v = 30;
    delayed.friction[0].delays.push_back({20, 5e-3});
    KernelTable g;
    g.time = {0, 4e-3, 9e-3, 2e-2}, g.value = {300, 500, -200, 100};  // changes sign, ends with a jump
    delayed.friction[0].table = std::make_shared<KernelTable>(g);
    const double omega = 40;
    const auto answer = forced_response(delayed, sampled_force(ForceKind::sine, 1, 10, 1e-3, omega));
    double largest = 0;
    for (std::size_t i = answer.time.size() * 3 / 4; i < answer.time.size(); ++i)
        largest = std::max(largest, std::abs(answer.position[i]));
    CHECK(largest == Approx(std::abs(disturbance_response(delayed, {0, omega}))).epsilon(2e-4));
}
