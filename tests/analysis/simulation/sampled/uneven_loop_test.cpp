// Loops that an encoder or noise disturbs at every tick: what small noise must not change, and slow motions that are
// decided nevertheless.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/cycles/uneven_follow.h"
#include "tests/analysis/simulation/joints.h"

#include <random>

using namespace stickslip;

namespace {

/// The bistable strip of the examples in a loop of this period, with an encoder of this step; 0: none.
Joint strip(double k_p, double period, double quantum)
{
    RateAndState law;
    law.f0 = 60, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5), law.L.push_back(1e-5);
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = k_p, joint.control.k_v = 47.5, joint.control.V0 = 1e-2;
    joint.control.period = period;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = law;
    joint.sensor.encoder_quantum = quantum;
    return joint;
}

constexpr double fine = 1e-9;  // of a cycle of 50 µm

/// A loop of 1 kHz about V_0 = 1 whose slow mode turns once a second.
UnevenOptions about_one(double decay)
{
    UnevenOptions options;
    options.V0 = 1, options.tick = 1e-3, options.turn = 1, options.decay = decay;
    options.steady_attracts = decay < 0;
    options.noise = 1e-3;
    return options;
}

/// Follows a position of this amplitude over time until it is decided; white noise of a hundredth beside it.
template <class Amplitude>
LoopEnd follow(UnevenFollow& follower, double seconds, const Amplitude& amplitude, double noise = 1e-3)
{
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0, noise);
    constexpr double omega = 2 * std::numbers::pi;
    for (long k = 0; k < std::lround(seconds * 1e3); ++k) {
        const double t = 1e-3 * static_cast<double>(k), a = amplitude(t);
        LoopTurn tick;
        tick.position_min = tick.position_max = a * std::sin(omega * t) + normal(random);
        tick.velocity_min = tick.velocity_max = 1 + a * omega * std::cos(omega * t) + normal(random);
        if (const auto end = follower.after_tick(tick)) return *end;
    }
    return follower.cut_short();
}

}  // namespace

TEST_CASE("uneven loop: a fine encoder changes no region of the bistable strip", "[sampled][slow]")
{
    // the fold lies between 25.9 and 26.9 kN/m
    for (const double k_p : {2.2e4, 2.5e4, 3e4}) {
        CAPTURE(k_p);
        NonlinearOptions longer;
        longer.effort = 10;
        const auto clean = nonlinear_verdict(strip(k_p, 2e-5, 0), longer);
        const auto read = nonlinear_verdict(strip(k_p, 2e-5, fine), {});
        CHECK(read.outcome == Outcome::stable_sliding);
        CHECK(read.region == clean.region);
        CHECK(read.region == (k_p < 2.6e4 ? NonlinearRegion::bistable : NonlinearRegion::stable));
        if (k_p < 2.6e4) CHECK(read.amplitude == Approx(clean.amplitude).epsilon(0.03));
        if (k_p < 2.6e4) CHECK(read.period == Approx(clean.period).epsilon(0.01));
    }
}

TEST_CASE("uneven loop: a cycle that grows slowly is waited for", "[sampled][slow]")
{
    for (const double k_p : {2e4, 3e4}) {
        CAPTURE(k_p);
        const auto clean = nonlinear_verdict(strip(k_p, 1e-4, 0), {});
        const auto read = nonlinear_verdict(strip(k_p, 1e-4, fine), {});
        CHECK(read.outcome == Outcome::limit_cycle);
        CHECK(read.region == NonlinearRegion::stick_slip);
        CHECK(read.amplitude == Approx(clean.amplitude).epsilon(0.05));
        CHECK(read.period == Approx(clean.period).epsilon(0.01));
    }
}

TEST_CASE("uneven loop: slow motions of a geared elbow are decided", "[sampled][slow]")
{
    // amplitudes of ten times as long a motion under another seed
    for (const auto& [k_p, amplitude] : {std::pair{2512.0, 62.3e-6}, {10e3, 10.7e-6}}) {
        CAPTURE(k_p);
        const auto verdict = nonlinear_verdict(creeping_elbow(k_p, 200, 2e-5), {});
        CHECK(verdict.outcome == Outcome::limit_cycle);
        CHECK(verdict.region == NonlinearRegion::stick_slip);
        CHECK(verdict.amplitude == Approx(amplitude).epsilon(0.1));
        CHECK(verdict.jitter < 0.1 * amplitude);
    }
    for (const double k_p : {15849.0, 39811.0, 1e5}) {
        CAPTURE(k_p);
        const auto verdict = nonlinear_verdict(creeping_elbow(k_p, 200, 2e-5), {});
        CHECK(verdict.outcome == Outcome::stable_sliding);
        CHECK(verdict.region == NonlinearRegion::stable);
    }
}

TEST_CASE("uneven loop: a motion ends where it neither grows nor fades", "[sampled]")
{
    SECTION("a cycle that is approached as from a supercritical Hopf point")
    {
        UnevenFollow follower(about_one(0.1));
        const auto end = follow(follower, 400, [](double t) { return 1 / std::sqrt(1 + 400 * std::exp(-0.2 * t)); });
        CHECK(end.kind == LoopEnd::Kind::cycle);
        CHECK(end.amplitude == Approx(1).epsilon(0.06));
        CHECK(end.period == Approx(1).epsilon(0.01));
        CHECK(end.jitter < 0.05);
    }
    SECTION("a motion that still grows is left open")
    {
        UnevenFollow follower(about_one(0.02));
        CHECK(follow(follower, 40, [](double t) { return 0.1 * std::exp(0.02 * t); }).kind == LoopEnd::Kind::undecided);
    }
    SECTION("a small motion of a loop that attracts is jitter")
    {
        UnevenFollow follower(about_one(-0.5));
        CHECK(follow(follower, 60, [](double) { return 2e-3; }).kind == LoopEnd::Kind::steady);
    }
    SECTION("larger ones fade into it or stay")
    {
        auto options = about_one(-0.5);
        options.jitter = {4e-3, 0.99, 1.01};
        UnevenFollow fades(options), stays(options);
        CHECK(follow(fades, 60, [](double t) { return std::exp(-0.5 * t); }).kind == LoopEnd::Kind::steady);
        const auto cycle = follow(stays, 60, [](double t) { return 0.1 + 0.02 * std::exp(-0.5 * t); });
        CHECK(cycle.kind == LoopEnd::Kind::cycle);
        CHECK(cycle.amplitude == Approx(0.1).epsilon(0.05));
    }
}
