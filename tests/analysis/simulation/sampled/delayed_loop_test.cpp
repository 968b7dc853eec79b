// Delayed friction in a sampled loop: windows of the linear theory from both sides, and cycles and records of
// an integrator of another kind, which is written out here.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/sampled/sampled_joint.h"

#include <deque>

using namespace stickslip;

namespace {

constexpr double lag = 5e-3, V0 = 1e-3, inertia = 1, k_v = 10, T = 1e-3;

/// Of slope −100 N·s/m at V_0.
Stribeck falling_curve()
{
    Stribeck curve;
    curve.c0 = 8, curve.c1 = 0, curve.c3 = 2e-3;
    curve.c2 = 100 / (2 * V0 / (2e-3 * 2e-3) * std::exp(-0.25));
    return curve;
}

Joint delayed_joint(double k_p, double delay, double delayed = lag)
{
    Joint joint;
    joint.mechanism.inertia = inertia;
    joint.control.k_p = k_p, joint.control.k_v = k_v, joint.control.V0 = V0;
    joint.control.period = T, joint.control.delay = delay;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    TimeLag law;
    law.lag = delayed;
    law.curve.law = falling_curve();
    joint.friction.law = law;
    return joint;
}

/// Slides at ever smaller steps: the body under a held force, its friction as large as at the speed a lag ago.
class SmallSteps {
  public:
    SmallSteps(const Stribeck& curve, double mass, double x, double v)
        : position(x), velocity(v), curve_(curve), mass_(mass), past_(static_cast<std::size_t>(lag / step) + 1, v)
    {
    }
    static constexpr int parts = 400;  // of a tick
    static constexpr double step = T / parts;
    double position, velocity;

    void hold(double force)
    {
        const double V = std::abs(past_.front());
        const double level = resistance(V), at_rest = std::max(resistance(0), level);
        const double before = velocity, direction = velocity != 0 ? velocity : force;
        if (velocity == 0 && std::abs(force) <= at_rest) {
            velocity = 0;
        } else {
            velocity += step / mass_ * (force - std::copysign(level, direction));
            if (before != 0 && velocity * before < 0) velocity = 0;
        }
        position += 0.5 * step * (before + velocity);
        past_.pop_front(), past_.push_back(velocity);
    }

  private:
    double resistance(double V) const
    {
        return curve_.c0 + curve_.c1 * V + curve_.c2 * std::exp(-V * V / curve_.c3 / curve_.c3);
    }
    Stribeck curve_;
    double mass_;
    std::deque<double> past_;
};

/// Half peak to peak of the excess over the steady path in the last part of a long motion.
double amplitude_by_small_steps(double k_p, int dead_ticks, double seconds)
{
    const Stribeck curve = falling_curve();
    const double steady = curve.c0 + curve.c2 * std::exp(-V0 * V0 / curve.c3 / curve.c3);
    const double start = -steady / k_p;  // behind the reference, which is at V_0 t
    SmallSteps body(curve, inertia, start + 0.2 * V0 / std::sqrt(k_p), V0);
    double before = body.position - V0 * T, least = infinity, most = -infinity;
    std::deque<double> line(static_cast<std::size_t>(dead_ticks), steady);
    const int ticks = static_cast<int>(seconds / T);
    for (int k = 0; k < ticks; ++k) {
        const double error = V0 * T * k - body.position, rate = (body.position - before) / T;
        before = body.position;
        line.push_back(k_p * error + k_v * (V0 - rate));
        for (int i = 0; i < SmallSteps::parts; ++i) {
            body.hold(line.front());
            if (k < ticks / 2) continue;
            const double excess = body.position - V0 * (T * k + SmallSteps::step * (i + 1));
            least = std::min(least, excess), most = std::max(most, excess);
        }
        line.pop_front();
    }
    return 0.5 * (most - least);
}

}  // namespace

TEST_CASE("late friction in a sampled loop: outcomes on both sides of the ends of its windows", "[sampled][late][slow]")
{
    for (const double delay : {0.0, 1e-3}) {
        const auto windows = linear_verdict(delayed_joint(2e4, delay, 20e-3)).state_variable.stable_intervals;
        REQUIRE(!windows.empty());
        LoopQuestion question;
        question.region = false;
        const auto kind = [&](double k_p) {
            return loop_verdict(delayed_joint(k_p, delay, 20e-3), question).stated.kind;
        };
        const auto& window = windows.front();
        CAPTURE(delay, window.low, window.high);
        CHECK(kind(window.low * 0.97) != LoopEnd::Kind::steady);
        CHECK(kind(window.low * 1.03) == LoopEnd::Kind::steady);
        CHECK(kind(window.high * 0.99) == LoopEnd::Kind::steady);
        CHECK(kind(window.high * 1.03) != LoopEnd::Kind::steady);
    }
}

TEST_CASE("late friction in a sampled loop: its cycle is that of small steps", "[sampled][late]")
{
    for (const int dead : {0, 1}) {
        const auto verdict = loop_verdict(delayed_joint(6e4, dead * T), {});
        REQUIRE(verdict.cycle.oscillates());
        CAPTURE(dead, verdict.cycle.period, verdict.cycle.stick_fraction);
        CHECK(verdict.cycle.amplitude == Approx(amplitude_by_small_steps(6e4, dead, 4)).epsilon(3e-3));
    }
}

TEST_CASE("late friction in a sampled loop: a small disturbance grows in the motion as the theory says",
          "[sampled][late]")
{
    const Joint joint = delayed_joint(9e4, 1e-3);
    const auto linear = linear_verdict(joint).state_variable;
    REQUIRE(linear.spectral_abscissa > 0);
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::offset, 1e-8 * V0 / 300};
    options.duration = 15 / linear.spectral_abscissa;
    options.rtol = 1e-12;
    const auto path = simulate(joint, options);
    REQUIRE(path.reason == Reason::none);
    // largest excess over a window early and late
    const auto size = [&](double from, double to) {
        double most = 0;
        for (std::size_t i = 0; i < path.time.size(); ++i)
            if (path.time[i] >= from && path.time[i] < to) most = std::max(most, std::abs(path.velocity[i] - V0));
        return most;
    };
    // over turns of the mode, late enough for the faster decaying ones to be gone
    const double s = linear.spectral_abscissa, turn = 2 * std::numbers::pi / std::abs(linear.eigenvalues[0].imag());
    const double from = 8 / s, turns = std::floor(5 / s / turn) * turn;
    const double growth = std::log(size(from + turns, from + turns + turn) / size(from, from + turn)) / turns;
    CHECK(growth == Approx(s).epsilon(5e-3));
}

TEST_CASE("late friction in a sampled loop: a record with reversals is that of small steps", "[sampled][late]")
{
    Joint joint = sampled_joint();
    TimeLag law;
    law.lag = lag;
    law.curve.law = Stribeck{5, 10, 3, 0.05, 2};
    joint.friction.law = law;
    const auto reference = swing(1.5, T);
    const auto record = record_along(joint, reference, 0);
    REQUIRE(record.reason == Reason::none);
    REQUIRE(record.time.size() == reference.time.size());
    SmallSteps body(Stribeck{5, 10, 3, 0.05, 2}, 2, 0, 0);
    double estimate = 0, before = 0, worst = 0;
    std::deque<double> line(2, 0.0);
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        worst = std::max(worst, std::abs(record.position[k] - body.position));
        if (k > 0) estimate += T / 4e-3 * ((body.position - before) / T - estimate);
        before = body.position;
        line.push_back(4000 * (reference.position[k] - body.position) + 120 * (reference.velocity[k] - estimate));
        for (int i = 0; i < SmallSteps::parts; ++i) body.hold(line.front());
        line.pop_front();
    }
    CHECK(worst < 5e-6);
}
