// Real loops at the edges of their numbers: found by tests/reliability/loops.py, kept one by one.
#include "analysis/stability/real_loop.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("A dead time far below every other time leaves the windows as they are without it", "[loop]")
{
    // slow roots beside it: those of the integral, k_i/k_p = 1e-3 1/s and less towards stiff springs
    for (const double k_i : {0.0, 100.0, 1e6}) {
        Joint joint = differencing_joint(60e3, 10);
        joint.control.k_i = k_i;
        const double prompt = linear_verdict(joint).state_variable.stable_intervals.at(0).low;
        for (const double delay : {1e-9, 1e-8, 1e-7}) {
            joint.control.delay = delay;
            const auto memory = linear_verdict(joint).state_variable;
            INFO("k_i " << k_i << " delay " << delay);
            REQUIRE(memory.stable_intervals.size() == 1);
            CHECK(memory.stable_intervals[0].low == Approx(prompt).epsilon(2e2 * delay / 1e-5 * 1e-2));
            CHECK(std::isfinite(memory.spectral_abscissa));
        }
    }
}

TEST_CASE("Three integrators beside slow roots are counted, none of them moved by rounding", "[loop]")
{
    // k_p 27 N/m with k_v 500: a root at −k_p/(k_v + …), a thousandth of what rounding makes of a triple pole at 0
    Joint joint = differencing_joint(27, 500);
    joint.friction.law = CoulombViscous{60, 20};
    joint.control.k_i = 0.02;
    joint.control.delay = 2e-3;
    const auto memory = linear_verdict(joint).state_variable;
    CHECK(memory.stable);
    // (k_v + viscous) s² + k_p s + k_i = 0 where the mass is slow
    CHECK(memory.spectral_abscissa == Approx(-0.02 / 27).epsilon(0.05));
    REQUIRE(memory.stable_intervals.size() == 1);
    CHECK(memory.stable_intervals[0].low < 27);
}

TEST_CASE("A sampled cascade with a measured velocity has one integrator", "[loop]")
{
    Joint joint = differencing_joint(0, 0);
    auto& c = joint.control;
    c.structure = Structure::cascade;
    c.velocity_estimate.form = EstimateForm::exact;
    c.position_gain = 300, c.velocity_gain = 220, c.velocity_integral_gain = 11000;
    const double prompt = growth_rate(joint);
    REQUIRE(prompt < 0);
    c.period = 1e-7;
    // its sums apart leave a multiplier at 1 for ever: neutral
    const auto memory = linear_verdict(joint).state_variable;
    CHECK(memory.stable);
    CHECK(memory.spectral_abscissa == Approx(prompt).epsilon(1e-3));
    REQUIRE_FALSE(memory.stable_intervals.empty());
    // told in k_p, as every window: K_v K_pos + K_i
    const auto k_p = [&] { return c.velocity_gain * c.position_gain + c.velocity_integral_gain; };
    const auto [low, high] = memory.stable_intervals.back();
    CHECK((k_p() > low && k_p() < high));
    c.period = 1e-3;
    const auto window = linear_verdict(joint).state_variable.stable_intervals.at(0);
    for (const double inside : {0.999, 1.001}) {
        c.position_gain = (window.high * inside - c.velocity_integral_gain) / c.velocity_gain;
        CHECK((growth_rate(joint) < 0) == (inside < 1));
    }
}

TEST_CASE("The effort of steady sliding is that at the velocity at which the joint slides", "[loop]")
{
    // an encoder that reads 0.8 per displacement: the joint slides 1/0.8 times as fast
    Joint scaled = differencing_joint(60e3, 10);
    scaled.friction.law = CoulombViscous{60, 5000};
    scaled.sensor.position_scale = 0.8;
    scaled.actuator.sag_effort = 100;
    Joint plain = scaled;
    plain.sensor.position_scale = 1;
    plain.control.V0 = scaled.control.V0 / 0.8;
    plain.control.k_p = 0.8 * 60e3, plain.control.k_v = 0.8 * 10;
    CHECK(growth_rate(scaled) == Approx(growth_rate(plain)).epsilon(1e-10));
}

TEST_CASE("An average of more readings than a map can hold is refused, not run out of memory over", "[loop]")
{
    Joint joint = differencing_joint(60e3, 10);
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.average = 1e8;
    CHECK(linear_verdict(joint).steady.reason == Reason::unsupported);
    CHECK(linear_point(joint).reason == Reason::unsupported);
}

TEST_CASE("A drive that pushes the wrong way is held by a contact up to the gain that undoes it", "[loop]")
{
    for (const double delay : {0.0, 1e-4}) {
        Joint joint = differencing_joint(10e3, 0);
        joint.friction.law = CoulombViscous{60, 500};
        joint.control.contact_stiffness = 30e3;
        joint.control.delay = delay;
        joint.actuator.effort_gain = -0.4;
        const auto memory = linear_verdict(joint).state_variable;
        CHECK(memory.stable);
        REQUIRE(memory.stable_intervals.size() == 1);
        CHECK(memory.stable_intervals[0].low == 0);
        CHECK(memory.stable_intervals[0].high == Approx(30e3 / 0.4).epsilon(1e-9));
        CHECK(memory.crossings.front().direction == 1);
    }
}

TEST_CASE("Under an integral the windows of the velocity gain of a sampled loop are found", "[loop]")
{
    // two zeros at z = 1, which rounding parts: the search ended between them and had no window
    Joint joint = stribeck_joint(20e3, 120, -1e-2);
    joint.mechanism.inertia = 5;
    joint.friction.law = Stribeck{.c0 = 8, .c1 = 40, .c2 = 5, .c3 = 6e-3};
    joint.friction.asymmetry.viscous = 5;
    auto& c = joint.control;
    c.k_i = 3e4, c.period = 2e-3, c.delay = 2e-3;
    c.velocity_estimate.form = EstimateForm::backward_difference, c.velocity_estimate.tau = 2e-3;
    const auto windows = linear_verdict(joint).velocity_only.stable_k_v;
    REQUIRE(windows.size() == 1);
    for (const double edge : {windows[0].low, windows[0].high})
        for (const double beside : {1 - 1e-6, 1 + 1e-6}) {
            c.k_v = edge * beside;
            INFO("k_v " << c.k_v);
            CHECK((growth_rate(joint) < 0) == (c.k_v > windows[0].low && c.k_v < windows[0].high));
        }
}

TEST_CASE("Where no gain but its own was looked at, a loop claims no set of stable gains", "[loop]")
{
    Joint joint = differencing_joint(20e3, 0);
    joint.friction.law = CoulombViscous{1.1, 22};
    joint.control.kind = ControlKind::force, joint.control.force_gain = 0.44, joint.control.delay = 3e-3;
    const auto memory = linear_verdict(joint).state_variable;
    REQUIRE(std::isfinite(memory.spectral_abscissa));
    CHECK(memory.stable_intervals.empty());
    CHECK(memory.searched_from == 20e3);
    CHECK(memory.searched_to == 20e3);
}
