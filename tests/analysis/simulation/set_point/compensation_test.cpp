// Pushes against dry friction at a set point: against equal small steps that know no events, and closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/set_point/set_point.h"
#include "analysis/simulation/set_point/stops.h"

using namespace stickslip;

namespace {

constexpr double pi = 3.14159265358979323846;

Joint held(double k_i, double breakaway, double coulomb = 1)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.V0 = 0;
    joint.control.k_p = 100;
    joint.control.k_v = 8;
    joint.control.k_i = k_i;
    joint.friction.law = KineticStatic{coulomb, breakaway};
    return joint;
}

FeedForward push(CoulombFrom from, double level, double speed, double width)
{
    FeedForward f;
    f.coulomb_from = from, f.coulomb = level, f.coulomb_speed = speed, f.coulomb_width = width;
    return f;
}

Joint pushed(Joint joint, const FeedForward& added)
{
    joint.control.feed_forward = added;
    return joint;
}

/// Where the first slip from −a ends, by the midpoint rule in equal steps: no events, no branches, no side.
double slip_by_small_steps(const Joint& joint, const FeedForward& c, double a, double dt)
{
    const auto& law = std::get<KineticStatic>(joint.friction.law);
    const auto& k = joint.control;
    const auto share = [&](double x, double v) {
        if (c.by_velocity()) return std::tanh(v / c.coulomb_speed);
        const double e = -x, side = e > c.coulomb_width    ? 1
                                    : e < -c.coulomb_width ? -1
                                    : c.coulomb_width > 0  ? e / c.coulomb_width
                                                           : 0;
        return side * (1 - std::tanh(std::abs(v) / c.coulomb_speed));
    };
    double x = -a, v = 0, w = law.breakaway - k.k_p * a - (c.by_error() ? c.coulomb * share(-a, 0) : 0);
    const auto pull = [&](double X, double V, double W) {
        return (-k.k_p * X - k.k_v * V + W + c.coulomb * share(X, V) - law.kinetic) / joint.mechanism.inertia;
    };
    for (long i = 0; i < 100'000'000; ++i) {
        const double X = x + 0.5 * dt * v, V = v + 0.5 * dt * pull(x, v, w), W = w - 0.5 * dt * k.k_i * x;
        x += dt * V, w -= dt * k.k_i * X, v += dt * pull(X, V, W);
        if (v <= 0) return x;
    }
    return missing;
}

bool hunts(const Joint& joint, const FeedForward& c)
{
    return set_point(pushed(joint, c)).hunting == Hunting::yes;
}

}  // namespace

TEST_CASE("a slip under a push ends where small equal steps end", "[set-point][slow]")
{
    const Joint joint = held(100, 1.5);
    for (const FeedForward& c : {push(CoulombFrom::error, 0.8, 1e9, 0), push(CoulombFrom::error, 0.8, 0.02, 0),
                                 push(CoulombFrom::error, 0.8, 0.02, 1e-3), push(CoulombFrom::velocity, 0.6, 0.02, 0)})
        for (const double a : {2e-3, 2e-2}) {
            const auto stop = StopToStop(regulator_of(pushed(joint, c)), joint.friction).slip_from(a);
            REQUIRE(stop.end != Stop::End::failure);
            if (stop.end != Stop::End::stop || stop.turns > 0) continue;
            const double expected = slip_by_small_steps(joint, c, a, 1e-6);
            CHECK(stop.x == Approx(expected).margin(1e-4 * a));
        }
}

TEST_CASE("short slips under a push shrink when it is more than the drop of friction", "[set-point]")
{
    // (F_s − F_c) up to the set point, (F_s − F_c) − 2S behind it: a' = a (F_s − F_c)/(2S − (F_s − F_c))
    const double drop = 0.5, a = 1e-9;
    const Joint joint = held(100, 1 + drop);
    for (const double S : {0.4, 0.55, 0.9, 1.4}) {
        const FeedForward c = push(CoulombFrom::error, S, 1e9, 0);
        const auto stop = StopToStop(regulator_of(pushed(joint, c)), joint.friction).slip_from(a);
        CHECK(stop.x / a == Approx(drop / (2 * S - drop)).epsilon(1e-3));
    }
}

TEST_CASE("a push between the drop and the static friction ends hunting, less does not", "[set-point][slow]")
{
    const double drop = 0.5;
    for (const double fade : {1e9, 0.05, 1e-3}) {
        const Joint joint = held(100, 1 + drop);
        CHECK(hunts(joint, {}));
        CHECK(hunts(joint, push(CoulombFrom::error, 0.97 * drop, fade, 0)));
        const auto calm = set_point(pushed(joint, push(CoulombFrom::error, 1.03 * drop, fade, 0)), {16});
        CHECK(calm.hunting == Hunting::no);
        CHECK(calm.starts > 100);
        CHECK(calm.largest_ratio < 1);
        CHECK(calm.own_level == Approx(1.5));
        CHECK(calm.compensation == Approx(1.03 * drop));
    }
}

TEST_CASE("a push above the static friction moves a joint whose loop is late", "[set-point]")
{
    const double breakaway = 1.5;
    Joint joint = held(0, breakaway);  // an integral may balance the push for as long as it takes to wind up
    joint.control.period = 1e-3;
    const auto by_error = [&](double S) { return set_point(pushed(joint, push(CoulombFrom::error, S, 1e9, 0))); };
    CHECK(by_error(0.99 * breakaway).hunting == Hunting::no);
    CHECK(by_error(1.01 * breakaway).hunting == Hunting::yes);
    CHECK(by_error(1.01 * breakaway).reason == SetPointReason::push_breaks_friction);
    // the same loop tick by tick, friction by small steps: still moving after a minute, or at rest for ever
    const auto moves = [&](double S) {
        const auto& k = joint.control;
        double x = -0.02, v = 0, last = 0;
        constexpr int inner = 20;
        const double dt = k.period / inner;
        bool moved = false;
        for (int tick = 0; tick < 60'000; ++tick) {
            const double u = -k.k_p * x - k.k_v * (tick > 0 ? (x - last) / k.period : 0) + S * ((x < 0) - (x > 0));
            last = x;
            for (int i = 0; i < inner; ++i) {
                if (v == 0 && std::abs(u) <= breakaway) break;
                const double sign = v != 0 ? (v > 0 ? 1 : -1) : (u > 0 ? 1 : -1);
                const double next = v + dt * (u - sign * 1.0);
                v = next * sign < 0 ? 0 : next;
                x += dt * v;
                if (tick > 50'000) moved = true;
            }
        }
        return moved;
    };
    CHECK_FALSE(moves(0.9 * breakaway));
    CHECK(moves(1.1 * breakaway));
}

TEST_CASE("feed-forward of the measured velocity drives a joint from F_c + F_s tanh on", "[set-point]")
{
    // from −a under D = S − F_c to X + ρ (a + X), X = D/k_p: a cycle of a = X (1 + ρ)/(1 − ρ) if k_p a > F_s
    for (const double breakaway : {1.0, 1.5}) {
        const Joint joint = held(0, breakaway);
        const double zeta = joint.control.k_v / (2 * std::sqrt(joint.control.k_p));
        const double critical = 1 + breakaway * std::tanh(0.5 * pi * zeta / std::sqrt(1 - zeta * zeta));
        const auto driven = [&](double S) { return set_point(pushed(joint, push(CoulombFrom::velocity, S, 1e-7, 0))); };
        CHECK(driven(0.999 * critical).hunting == Hunting::no);
        const auto cycle = driven(1.001 * critical);
        CHECK(cycle.hunting == Hunting::yes);
        const double rho = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)), X = (1.001 * critical - 1) / 100;
        CHECK(cycle.amplitude == Approx(X * (1 + rho) / (1 - rho)).epsilon(1e-4));
        CHECK(cycle.multiplier == Approx(rho).epsilon(1e-3));
        CHECK(cycle.slip_time == Approx(pi / (10 * std::sqrt(1 - zeta * zeta))).epsilon(1e-3));
    }
}
