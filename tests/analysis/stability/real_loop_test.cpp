// The loop as it is, against told numbers of the monodromy and of quasi-polynomials, and against closed forms.
#include "analysis/stability/real_loop.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

struct Told {
    double period, tau, delay, lag, k_v, low, high;  // high 0: no window; low 0: from 0
};

constexpr Told table[] = {{1e-3, 0, 0, 0, 10, 57140.00431, 2344952.884},
                          {1e-3, 0, 1e-3, 0, 10, 65653.0352, 738521.1804},
                          {1e-3, 0, 0, 2e-3, 10, 79794.61607, 626358.4025},
                          {1e-3, 3e-3, 2e-3, 1e-3, 10, 107625.5615, 240625.7352},
                          {0.5e-3, 0, 10e-3, 0, 10, 0, 0},
                          {0.5e-3, 0, 10e-3, 0, 600, 0, 64559.36351},
                          {not_set, 0, 1e-3, 0, 10, 61024.53743, 1094262.608},
                          {not_set, 3e-3, 2e-3, 1e-3, 10, 89607.55052, 328194.1879}};

Joint told_joint(const Told& t)
{
    Joint joint = differencing_joint(60e3, t.k_v);
    joint.control.period = t.period;
    joint.control.velocity_estimate.tau = t.tau;
    joint.control.delay = t.delay;
    joint.actuator.lag = t.lag;
    return joint;
}

}  // namespace

TEST_CASE("a window whose ends lie close together in frequency is found")
{
    // K_pos of a cascade on a DC motor behind dead time: the border is crossed at 90.4 and 116.7 rad/s, between which
    // the phase turns by 0.003 rad. The ends are those of a spectral discretization of the dead time, apart from the
    // program.
    Joint joint = differencing_joint(60e3, 0);
    joint.mechanism.inertia = 9.294175147136288;
    RateAndState law;
    law.f0 = 30.183979730417708, law.A = 2.769646854583959, law.V_star = 0.00012060918189380325;
    for (const double B : {2.1833762459122683, 1.0626667523027444, 1.2159853506853087}) law.B.push_back(B);
    for (const double L : {2.1361305358199915e-06, 6.18109218071339e-05, 2.8960509119625165e-05}) law.L.push_back(L);
    joint.friction.law = law;
    joint.actuator.kind = ActuatorKind::dc_motor;
    joint.actuator.k_t = 3.0554387805530228, joint.actuator.k_e = 0.4066004943459535;
    joint.actuator.resistance = 1.480540011049333, joint.actuator.effort_gain = 0.6608553194813112;
    auto& c = joint.control;
    c.V0 = 0.0043450845410590196, c.delay = 0.0010034980221637845;
    c.velocity_estimate = {};
    c.velocity_estimate.tau = 0.0004136425069372048;
    c.k_v = 191.22651095365833, c.k_p = 177.8269608314216 * c.k_v;
    const auto windows = linear_verdict(joint).state_variable.stable_intervals;
    REQUIRE(windows.size() == 1);
    CHECK(windows[0].low == Approx(372.637512117 * c.k_v).epsilon(1e-8));
    CHECK(windows[0].high == Approx(591.847591198 * c.k_v).epsilon(1e-8));
}

TEST_CASE("Windows of stable k_p of real loops are those that were told")
{
    for (const auto& t : table) {
        const auto verdict = linear_verdict(told_joint(t));
        const auto& windows = verdict.state_variable.stable_intervals;
        INFO("period " << t.period << " delay " << t.delay << " lag " << t.lag << " k_v " << t.k_v);
        if (t.high == 0) {
            CHECK(windows.empty());
            continue;
        }
        REQUIRE(windows.size() == 1);
        CHECK(windows[0].low == Approx(t.low).epsilon(1e-9).margin(1e-9));
        CHECK(windows[0].high == Approx(t.high).epsilon(1e-9));
        CHECK(verdict.state_variable.stable == (60e3 > t.low && 60e3 < t.high));
        CHECK(verdict.state_variable.doubtful.empty());
    }
}

TEST_CASE("Dead time counts wherever in the loop it arises")
{
    for (const auto& t : table) {
        if (t.high == 0 || t.delay == 0) continue;
        Joint joint = told_joint(t);
        joint.sensor.delay = 0.7 * joint.control.delay;
        joint.control.delay *= 0.3;
        const auto verdict = linear_verdict(joint);
        INFO("period " << t.period << " delay " << t.delay << " lag " << t.lag << " k_v " << t.k_v);
        REQUIRE(verdict.state_variable.stable_intervals.size() == 1);
        CHECK(verdict.state_variable.stable_intervals[0].low == Approx(t.low).epsilon(1e-9).margin(1e-9));
        CHECK(verdict.state_variable.stable_intervals[0].high == Approx(t.high).epsilon(1e-9));
        CHECK(std::ranges::count(verdict.loop.used, "sensor.delay") == 1);
    }
}

TEST_CASE("The integral moves the critical gain to the root of a quadratic")
{
    const std::pair<double, double> told[] = {
        {0, 53851.485149}, {1e5, 56087.395801}, {1e6, 70075.894106}, {1e7, 119363.430440}};
    for (const auto& [k_i, k_cr] : told) {
        Joint joint = differencing_joint(60e3, 10);
        joint.control.k_i = k_i;
        const auto verdict = linear_verdict(joint);
        INFO("k_i " << k_i);
        CHECK(verdict.state_variable.k_cr == Approx(k_cr).epsilon(1e-10));
        CHECK(verdict.loop.kind == (k_i == 0 ? LoopKind::ideal : LoopKind::continuous));
    }
}

TEST_CASE("A cascade has the spectrum of its sum of gains")
{
    for (const bool sampled : {false, true}) {
        Joint cascade = differencing_joint(0, 0), sum = cascade;
        cascade.control.structure = Structure::cascade;
        cascade.control.position_gain = 300;
        cascade.control.velocity_gain = 220;
        cascade.control.velocity_reset_time = 0.02;
        const double K_i = 220 / 0.02;
        sum.control.k_p = 220 * 300 + K_i;
        sum.control.k_v = 220;
        sum.control.k_i = K_i * 300;
        if (sampled)
            cascade.control.period = sum.control.period = 1e-3, cascade.control.delay = sum.control.delay = 0.4e-3;
        const auto a = linear_verdict(cascade).state_variable, b = linear_verdict(sum).state_variable;
        REQUIRE(a.eigenvalues.size() == b.eigenvalues.size());
        CHECK(a.spectral_abscissa == Approx(b.spectral_abscissa).epsilon(1e-12));
        for (std::size_t i = 0; i < a.eigenvalues.size(); ++i)
            CHECK(std::abs(a.eigenvalues[i] - b.eigenvalues[i]) <= 1e-12 * std::abs(b.eigenvalues[i]));
    }
}

TEST_CASE("As period, delay, lag and filter go to nothing the ideal loop comes out")
{
    const double ideal = linear_verdict(differencing_joint(60e3, 10)).state_variable.k_cr;
    const auto lower = [](auto change) {
        const auto at = [&](double h) {
            Joint joint = differencing_joint(60e3, 10);
            change(joint, h);
            return linear_verdict(joint).state_variable.stable_intervals.at(0).low;
        };
        // the first two orders in h drop out
        const double a = at(4e-6), b = at(2e-6), c = at(1e-6);
        return (8 * c - 6 * b + a) / 3;
    };
    CHECK(lower([](Joint& j, double h) { j.control.period = h; }) == Approx(ideal).epsilon(1e-9));
    CHECK(lower([](Joint& j, double h) { j.control.delay = h; }) == Approx(ideal).epsilon(1e-9));
    CHECK(lower([](Joint& j, double h) { j.actuator.lag = h; }) == Approx(ideal).epsilon(1e-9));
    CHECK(lower([](Joint& j, double h) { j.control.velocity_estimate.tau = h; }) == Approx(ideal).epsilon(1e-9));
}

TEST_CASE("A motor damps by its back-EMF, and a limit below friction leaves no sliding")
{
    Joint joint = differencing_joint(60e3, 10);
    joint.actuator.kind = ActuatorKind::dc_motor;
    joint.actuator.k_t = 2;
    joint.actuator.k_e = 5;
    joint.actuator.resistance = 0.5;
    const double damped = linear_verdict(joint).state_variable.stable_intervals.at(0).low;
    Joint same = differencing_joint(60e3, 10 * 4 + 2 * 5 / 0.5);  // k_t/R = 4 on the command, k_t k_e/R beside it
    CHECK(4 * damped == Approx(linear_verdict(same).state_variable.k_cr).epsilon(1e-9));

    Joint weak = differencing_joint(60e3, 10);
    weak.control.effort_limit = 59;
    CHECK(linear_verdict(weak).steady.reason == Reason::limit_too_low);
    weak.control.effort_limit = 61;
    CHECK(linear_verdict(weak).steady.reason == Reason::none);
}

TEST_CASE("The reference joint at 60 kN/m is unstable behind one tick of dead time, and says which loop it has")
{
    const auto verdict = linear_verdict(told_joint(table[1]));
    CHECK_FALSE(verdict.state_variable.stable);
    CHECK(verdict.loop.kind == LoopKind::sampled);
    CHECK(verdict.loop.used ==
          std::vector<std::string>{"control.period", "control.delay", "control.velocity_estimate.form"});
    CHECK(linear_verdict(with_ideal_loop(told_joint(table[1]))).state_variable.stable);
}

TEST_CASE("A falling curve that overflows within one tick is unstable, and has no window")
{
    // by its curve alone 5e-4 kg runs away at 500 N·s/m over 5e-4 kg: by e^1000 in 1 ms, and no k_v of 10 N·s/m behind
    // the tick changes that rate by more than ln 10 in 1000
    Joint joint = told_joint(table[0]);
    joint.mechanism.inertia = 5e-4;
    CHECK(velocity_only_growth_rate(joint) == Approx(500 / 5e-4).epsilon(1e-2));
    CHECK(linear_point(joint).velocity_only_stable == 0);
    CHECK(linear_verdict(joint).velocity_only.stable_k_v.empty());
}
