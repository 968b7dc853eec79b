// Forces and normal loads that change in time: against the linear theory for small ones, against closed forms of
// springs and Coulomb friction for large ones.
#include <catch2/catch.hpp>

#include "analysis/simulation/simulate.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/joint/sample_joints.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

/// Position at the end of each sample; the solver ends a step at every change of the force.
std::vector<double> positions_at(const Trajectory& t, const std::vector<double>& times)
{
    std::vector<double> x;
    std::size_t i = 0;
    for (const double time : times) {
        while (i + 1 < t.time.size() && t.time[i] < time * (1 - 1e-12)) ++i;
        x.push_back(t.position[i]);
    }
    return x;
}

Joint lagged_joint()
{
    Joint joint = stribeck_joint(2e5, 3000, 2e-3);
    TimeLag law;
    law.lag = 2e-3;
    Stribeck curve;
    curve.c0 = 8, curve.c1 = 20, curve.c2 = 6, curve.c3 = 2e-3;
    law.curve.law = curve;
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("small forces in time move every kind of joint as the linear theory says", "[simulation]")
{
    Joint two = samples::two_mass();
    two.control.k_p = 2e5, two.control.k_v = 800;
    for (const auto& joint : {example_joint(8e4, 50, 1e-3), stribeck_joint(2e4, 3000, 2e-3), two, lagged_joint()}) {
        for (const auto kind : {ForceKind::impulse, ForceKind::step, ForceKind::sine, ForceKind::noise}) {
            const double m = joint.mechanism.model == Model::single_mass ? 1 : joint.mechanism.link_inertia;
            const double size = kind == ForceKind::impulse ? 1e-6 * m * joint.control.V0 : 1e-5;
            SimulateOptions options;
            options.rtol = 1e-11;
            options.force = sampled_force(kind, size, 0.1, 1e-3, 150);
            options.duration = 0.1;
            const auto motion = simulate(joint, options);
            REQUIRE(motion.reason == Reason::none);
            const auto linear = forced_response(linear_joint(joint, commanded_velocity(joint)), options.force);
            double largest = 0, gap = 0;
            const bool sampled = kind == ForceKind::sine || kind == ForceKind::noise;
            const auto x = sampled ? positions_at(motion, linear.time) : std::vector<double>{motion.position.back()};
            for (std::size_t i = 0; i < linear.time.size(); ++i)
                largest = std::max(largest, std::abs(linear.position[i]));
            for (std::size_t i = 0; i < x.size(); ++i)
                gap = std::max(gap, std::abs(x[x.size() - 1 - i] - linear.position[linear.position.size() - 1 - i]));
            INFO(info(joint.friction.law).name << ", " << static_cast<int>(kind));
            CHECK(gap / largest < 1e-3);
        }
    }
}

TEST_CASE("Coulomb friction under a changing normal load pushes the spring as a force would", "[simulation]")
{
    Joint joint = stribeck_joint(5000, 10, 1);
    joint.mechanism.inertia = 2;
    CoulombViscous law;
    law.coulomb = 4, law.viscous = 0;
    joint.friction.law = law;
    SimulateOptions options;
    options.duration = 0.3;
    options.normal_load = {0.1, {1, 1.5, 0.7}};
    options.rtol = 1e-11;
    const auto motion = simulate(joint, options);
    REQUIRE(motion.reason == Reason::none);
    // m ẍ + k_v ẋ + k_p x = f_c (1 − n): two steps of the damped oscillator, n − 1 = 0.5 from 0.1 s and −0.8 more at
    // 0.2 s
    const double decay = 2.5, damped = std::sqrt(2500 - decay * decay);
    const auto step = [&](double t) {
        return (1 - std::exp(-decay * t) * (std::cos(damped * t) + decay / damped * std::sin(damped * t))) / 5000;
    };
    CHECK(motion.position.back() == Approx(4 * (-0.5 * step(0.2) + 0.8 * step(0.1))).epsilon(1e-6));
}

TEST_CASE("a load that falls lets a stuck mass go at once", "[simulation]")
{
    Joint joint = stribeck_joint(1000, 100, 1e-2);
    KineticStatic law;
    law.kinetic = 5, law.breakaway = 8;
    joint.friction.law = law;
    SimulateOptions options;
    options.duration = 3;
    options.normal_load = {1, {1, 3, 1}};  // sliding; holds up to 24 N while the spring gains 10 N; breaks away
    const auto motion = simulate(joint, options);
    REQUIRE(motion.reason == Reason::none);
    double stuck_from = 0, stuck_to = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
        if (!motion.stuck[i]) continue;
        if (stuck_from == 0) stuck_from = motion.time[i];
        if (motion.time[i] <= 2) stuck_to = motion.time[i];
    }
    CHECK(stuck_from > 1);
    CHECK(stuck_from < 1.01);
    CHECK(stuck_to == Approx(2));
    // the instant of the jump has both its sides: stuck under the load before it, sliding under the next
    const auto after = std::upper_bound(motion.time.begin(), motion.time.end(), 2.0) - motion.time.begin();
    CHECK(motion.time[after - 1] == 2);
    CHECK(motion.stuck[after - 1]);
    CHECK_FALSE(motion.stuck[after]);
    CHECK(motion.time[after] == Approx(2).epsilon(1e-15));
    CHECK(std::adjacent_find(motion.time.begin(), motion.time.end(), std::greater_equal<>()) == motion.time.end());
    double fastest = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i)
        if (motion.time[i] > 2 && motion.time[i] < 2.2) fastest = std::max(fastest, motion.velocity[i]);
    CHECK(fastest > 2e-2);
}

TEST_CASE("a joint that starts under another load slides steadily under it", "[simulation]")
{
    SimulateOptions options;
    options.duration = 1;
    options.normal_load = {0.5, {1.3, 1.3}};
    const auto motion = simulate(example_joint(2e5, 100, 1e-3), options);
    REQUIRE(motion.reason == Reason::none);
    CHECK(motion.steady_friction == Approx(1.3 * 60));
    double largest = 0;
    for (const double x : motion.position) largest = std::max(largest, std::abs(x));
    CHECK(largest < 1e-12);
}

TEST_CASE("a law that needs motion is not pushed to rest", "[simulation]")
{
    SimulateOptions options;
    options.force = sampled_force(ForceKind::impulse, -1, 0.1, 0.01);
    CHECK(simulate(example_joint(2e5, 100, 1e-3), options).reason == Reason::law_needs_motion);
}

TEST_CASE("critical gain grows with the normal load as with A and B", "[stability]")
{
    for (const double n : {0.5, 1.7}) {
        Joint loaded = example_joint(6e4, 20, 1e-3);
        loaded.friction.normal_load = n;
        const double C = 20 + n * 1 / 1e-3;
        const double k_cr =
            (n * 0.5 - 20 * 1e-3) / 1e-5 * (1 + 1e-3 / (1e-5 * C));  // (34), (35) solved by hand for one state
        CHECK(linear_verdict(loaded).state_variable.k_cr == Approx(k_cr).epsilon(1e-10));
        CHECK(steady_sliding(loaded).friction == Approx(n * 60));
    }
    Joint delayed = lagged_joint(), heavy = delayed;
    auto& curve = std::get<Stribeck>(std::get<TimeLag>(heavy.friction.law).curve.law);
    curve.c0 *= 2, curve.c1 *= 2, curve.c2 *= 2;
    delayed.friction.normal_load = 2;
    delayed.control.k_v = heavy.control.k_v = 3000;
    const auto a = linear_verdict(delayed).state_variable, b = linear_verdict(heavy).state_variable;
    REQUIRE(a.crossings.size() == b.crossings.size());
    CHECK(a.spectral_abscissa == Approx(b.spectral_abscissa).epsilon(1e-9));
}
