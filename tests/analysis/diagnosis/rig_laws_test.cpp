// The laws of a friction rig against those of friction/: one velocity step of a massless slider behind its spring,
// where the law of friction/ is stepped by classical Runge-Kutta, and the slider's speed found by bisection. A memory
// that fades over time alone (RigLaw::time) and drift have no law there.
#include "analysis/diagnosis/rig/rig_laws.h"
#include "analysis/friction/friction.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double V_star = 3e-6, A = 0.008, B = 0.009, L = 6e-6, stiffness = 3000;  // m/s, N, N, m, N/m
constexpr double step_at = 10, row = 0.02, level = 0.6;                            // s, s, N
constexpr int rows = 1500;
constexpr double of_midpoint_rule = 0.01;  ///< with four steps a time constant: a sixth of (1/4)²

/// The load point goes at V* first, then at `factor` times that.
Rig stepped_rig(double factor)
{
    RigRun run;
    run.start_speed = V_star;
    for (int k = 0; k < rows; ++k) {
        const double t = row * k;
        run.time.push_back(t);
        run.displacement.push_back(V_star * (std::min(t, step_at) + factor * std::max(0.0, t - step_at)));
        run.friction.push_back(0);
    }
    Rig rig;
    rig.speed = V_star;
    rig.runs = {run};
    rig.levels = 1;
    return rig;
}

template <class Law>
Law remembering()
{
    Law law;
    law.f0 = level, law.A = A, law.V_star = V_star;
    law.B.push_back(B), law.L.push_back(L);
    return law;
}

/// The slider's speed: where the law resists as the spring pulls. Friction rises with speed at a given state.
double speed_at(const Friction& friction, double pull, const States& theta)
{
    double slow = std::log(V_star) - 20, fast = std::log(V_star) + 20;
    for (int i = 0; i < 48; ++i) {
        const double middle = 0.5 * (slow + fast);
        (respond(friction, std::exp(middle), theta).force < pull ? slow : fast) = middle;
    }
    return std::exp(0.5 * (slow + fast));
}

/// Force less its level, row by row, of a slider under a law with one state.
std::vector<double> by_law(const Friction& friction, const RigRun& run)
{
    constexpr int parts = 8;  // of a row
    std::vector<double> force;
    States theta = steady_state(friction, V_star);
    double stretch = level / stiffness;  // of the spring
    const auto rates = [&](double pulled, double s, double th) {
        States states{};
        states[0] = th;
        const double V = speed_at(friction, stiffness * s, states);
        return std::pair{pulled - V, respond(friction, V, states).rate[0]};
    };
    for (std::size_t k = 0; k < run.time.size(); ++k) {
        force.push_back(stiffness * stretch - level);
        if (k + 1 == run.time.size()) break;
        const double h = (run.time[k + 1] - run.time[k]) / parts;
        const double pulled = (run.displacement[k + 1] - run.displacement[k]) / (run.time[k + 1] - run.time[k]);
        for (int i = 0; i < parts; ++i) {
            const double s = stretch, th = theta[0];
            const auto [s1, t1] = rates(pulled, s, th);
            const auto [s2, t2] = rates(pulled, s + h / 2 * s1, th + h / 2 * t1);
            const auto [s3, t3] = rates(pulled, s + h / 2 * s2, th + h / 2 * t2);
            const auto [s4, t4] = rates(pulled, s + h * s3, th + h * t3);
            stretch += h / 6 * (s1 + 2 * s2 + 2 * s3 + s4);
            theta[0] += h / 6 * (t1 + 2 * t2 + 2 * t3 + t4);
        }
    }
    return force;
}

Friction with(const FrictionLaw& law)
{
    Friction friction;
    friction.law = law;
    return friction;
}

}  // namespace

TEST_CASE("a rig's memory answers a velocity step as the laws of friction do, slip and ageing", "[gap][rig][slow]")
{
    const std::pair<RigLaw, Friction> laws[] = {{RigLaw::slip, with(remembering<RateAndState>())},
                                                {RigLaw::ageing, with(remembering<Ageing>())}};
    for (const double factor : {10.0, 0.1})
        for (const auto& [law, friction] : laws) {
            const Rig rig = stepped_rig(factor);
            const auto fast = rig_force(rig, law, {stiffness, A, B, L})[0];
            const auto exact = by_law(friction, rig.runs[0]);
            double largest = 0, swing = 0;
            for (std::size_t k = 0; k < exact.size(); ++k) {
                largest = std::max(largest, std::abs(fast[k] - exact[k]));
                swing = std::max(swing, std::abs(exact[k]));
            }
            INFO((law == RigLaw::slip ? "slip" : "ageing")
                 << ", speed times " << factor << ": " << largest << " of " << swing << " N");
            CHECK(swing > A);  // the direct effect shows
            // a faster slider has slid on for long enough; a slower one would take minutes
            if (factor > 1) CHECK(exact.back() == Approx((A - B) * std::log(factor)).epsilon(0.02));
            CHECK(largest < of_midpoint_rule * swing);
        }
}

TEST_CASE("what a rig's slider resists without a memory is what the laws of friction do", "[gap][rig]")
{
    constexpr double factor = 10;
    const Rig rig = stepped_rig(factor);
    const auto rise = [&](RigLaw law, const RigNumbers& numbers) {
        const auto force = rig_force(rig, law, numbers)[0];
        return force.back() - force.front();
    };
    const auto rise_of = [&](const Friction& friction) {
        return respond(friction, factor * V_star, steady_state(friction, factor * V_star)).force -
               respond(friction, V_star, steady_state(friction, V_star)).force;
    };
    CoulombViscous viscous;
    viscous.coulomb = level, viscous.viscous = 400;
    CHECK(rise(RigLaw::level, {stiffness}) == rise_of(with(CoulombViscous{level, 0})));
    CHECK(rise(RigLaw::velocity, {stiffness, viscous.viscous}) == Approx(rise_of(with(viscous))));
    const Friction remembers = with(remembering<RateAndState>());
    CHECK(rise(RigLaw::logarithm, {stiffness, A - B}) == Approx(rise_of(remembers)));
    // a load that doubles in the last row: all of the friction is in proportion to it
    Rig loaded = rig;
    loaded.runs[0].normal.assign(rows, 50);
    loaded.runs[0].normal.back() = 100;
    Friction twice = with(CoulombViscous{level, 0});
    twice.normal_load = 2;
    const auto force = rig_force(loaded, RigLaw::load, {stiffness, level / 50})[0];
    CHECK(force.back() - force.front() == Approx(respond(twice, V_star, {}).force - level));
}
