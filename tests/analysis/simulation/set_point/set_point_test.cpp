// Hunting at a set point: known numbers, and motions that know nothing of the closed form.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "analysis/simulation/set_point/set_point.h"
#include "analysis/simulation/set_point/slip.h"
#include "analysis/simulation/set_point/stops.h"

using namespace stickslip;

namespace {

constexpr unsigned seed = 20261122;

class Draw {
  public:
    double log_uniform(double low, double high)
    {
        return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(random_));
    }
    /// A loop that is stable by Routh, from far within to near its edge: `least` is the least k_i as a share of that
    /// there.
    PidMass stabilising(double least = 1e-6)
    {
        PidMass p;
        p.inertia = log_uniform(0.01, 100);
        p.damping = log_uniform(0.01, 1e4);
        p.k_p = log_uniform(0.1, 1e6);
        p.k_i = p.damping * p.k_p / p.inertia * log_uniform(least, 0.97);
        return p;
    }

  private:
    std::mt19937_64 random_{seed};
};

Joint joint_of(const PidMass& p, const FrictionLaw& law)
{
    Joint joint;
    joint.mechanism.inertia = p.inertia;
    joint.control.V0 = 0;
    joint.control.k_p = p.k_p;
    joint.control.k_v = p.damping;
    joint.control.k_i = p.k_i;
    joint.friction.law = law;
    return joint;
}

/// Where a slip from −a ends, by the fourth-order formula of Runge and Kutta in small equal steps.
struct RungeKutta {
    double x, time;
};
RungeKutta slip_by_runge_kutta(const PidMass& p, double coulomb, double breakaway, double a)
{
    std::array<double, 3> y{-a, 0, breakaway - p.k_p * a};  // x, v, k_i ∫e
    const auto rate = [&](const std::array<double, 3>& s) {
        return std::array<double, 3>{s[1], (-p.k_p * s[0] - p.damping * s[1] + s[2] - coulomb) / p.inertia,
                                     -p.k_i * s[0]};
    };
    const double h = 2e-5;
    for (double t = 0;; t += h) {
        const auto plus = [&](const std::array<double, 3>& k, double share) {
            return std::array<double, 3>{y[0] + share * k[0], y[1] + share * k[1], y[2] + share * k[2]};
        };
        const auto k1 = rate(y), k2 = rate(plus(k1, h / 2)), k3 = rate(plus(k2, h / 2)), k4 = rate(plus(k3, h));
        auto next = y;
        for (int i = 0; i < 3; ++i) next[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        if (next[1] <= 0) {
            const double share = y[1] / (y[1] - next[1]);  // the velocity is straight over so short a time
            return {y[0] + 0.5 * share * h * y[1], t + share * h};
        }
        y = next;
    }
}

}  // namespace

TEST_CASE("the cycles of two published set points", "[set-point]")
{
    struct Row {
        PidMass mass;
        double coulomb, breakaway, a, T, T_s, period, multiplier;
    };
    const Row rows[] = {
        {{1, 2, 18, 30}, 0.327, 0.981, 0.034011984, 0.74103591, 0.71437116, 2.9108142, -0.15036519},
        {{1, 20, 100, 100}, 1, 1.5, 0.0023952231, 0.51158406, 10.362174, 21.747516, -0.70382501},
    };
    for (const auto& row : rows) {
        const auto s = set_point(joint_of(row.mass, KineticStatic{row.coulomb, row.breakaway}));
        REQUIRE(s.hunting == Hunting::yes);
        CHECK(s.method == SetPointMethod::closed_form);
        CHECK(s.amplitude == Approx(row.a).epsilon(1e-7));
        CHECK(s.slip_time == Approx(row.T).epsilon(1e-7));
        CHECK(s.stick_time == Approx(row.T_s).epsilon(1e-7));
        CHECK(s.period == Approx(row.period).epsilon(1e-7));
        CHECK(s.multiplier == Approx(row.multiplier).epsilon(1e-7));
        const auto end = slip_by_runge_kutta(row.mass, row.coulomb, row.breakaway, s.amplitude);
        CHECK(end.x == Approx(s.amplitude).epsilon(1e-7));
        CHECK(end.time == Approx(s.slip_time).epsilon(1e-7));
    }
}

TEST_CASE("every stable loop hunts where static friction exceeds Coulomb friction", "[set-point]")
{
    Draw draw;
    for (int i = 0; i < 600; ++i) {
        const auto p = draw.stabilising();
        const double coulomb = draw.log_uniform(0.01, 10), breakaway = coulomb + draw.log_uniform(0.01, 10);
        INFO("m " << p.inertia << " c " << p.damping << " k_p " << p.k_p << " k_i " << p.k_i << " F_c " << coulomb);
        const auto joint = joint_of(p, KineticStatic{coulomb, breakaway});
        const auto s = set_point(joint);
        REQUIRE(s.hunting == Hunting::yes);
        CHECK(std::abs(s.multiplier) < 1);
        // simulated by events, the slip ends where the next begins, and the stop lasts as long
        const auto stop = StopToStop(regulator_of(joint), joint.friction).slip_from(s.amplitude);
        REQUIRE(stop.end == Stop::End::stop);
        CHECK(stop.turns == 0);
        CHECK(stop.x == Approx(s.amplitude).epsilon(1e-7));
        CHECK(stop.slip_time == Approx(s.slip_time).epsilon(1e-6));
        CHECK(stop.stick_time == Approx(s.stick_time).epsilon(1e-6));
    }
}

TEST_CASE("no stable loop hunts where static friction equals Coulomb friction", "[set-point][slow]")
{
    Draw draw;
    for (int i = 0; i < 600; ++i) {
        const auto p = draw.stabilising(1e-2);
        const double coulomb = draw.log_uniform(0.01, 10);
        const auto joint = joint_of(p, CoulombViscous{coulomb, 0});
        const auto s = set_point(joint);
        REQUIRE(s.hunting == Hunting::no);
        CHECK(s.reason == SetPointReason::static_is_coulomb);
        // a nearly undamped swing touches rest again and again for hours: events are compared where it dies away
        if (p.damping < 0.04 * std::sqrt(p.k_p * p.inertia)) continue;
        // any slip ends nearer to the set point, and by the factor of the closed form
        const double a = coulomb / p.k_p * draw.log_uniform(1e-3, 10);
        const auto stop = StopToStop(regulator_of(joint), joint.friction).slip_from(a);
        INFO("m " << p.inertia << " c " << p.damping << " k_p " << p.k_p << " k_i " << p.k_i << " a " << a);
        if (stop.end == Stop::End::settled) continue;
        REQUIRE(stop.end == Stop::End::stop);
        CHECK(std::abs(stop.x) < a);
        if (stop.turns == 0) CHECK(stop.x / a == Approx(s.multiplier).epsilon(1e-5).margin(1e-7));
    }
}

TEST_CASE("a falling curve hunts like a drop where it falls at once, and not where it hardly falls", "[set-point]")
{
    const PidMass p{1, 2, 18, 30};
    const auto sharp = set_point(joint_of(p, Stribeck{0.327, 0, 0.654, 1e-5, 2}));
    const auto drop = set_point(joint_of(p, KineticStatic{0.327, 0.981}));
    REQUIRE(sharp.hunting == Hunting::yes);
    CHECK(sharp.method == SetPointMethod::event_driven);
    CHECK(sharp.amplitude == Approx(drop.amplitude).epsilon(1e-2));
    const auto blunt = set_point(joint_of(p, Stribeck{0.327, 0, 0.654, 10, 2}));
    CHECK(blunt.hunting == Hunting::no);
    CHECK(blunt.reason == SetPointReason::slips_shrink);
}

TEST_CASE("a limit of the integral ends the hunting; beside a dead zone a cycle remains", "[set-point]")
{
    const PidMass p{1, 2, 18, 30};
    auto joint = joint_of(p, KineticStatic{0.327, 0.981});
    joint.control.integral_limit = 100;  // never reached: the same cycle, by events
    auto s = set_point(joint);
    REQUIRE(s.hunting == Hunting::yes);
    CHECK(s.method == SetPointMethod::event_driven);
    CHECK(s.amplitude == Approx(0.034011984).epsilon(1e-6));
    CHECK(s.multiplier == Approx(-0.15036519).epsilon(1e-4));
    joint.control.integral_limit = 0.3;  // 18 · 0.034 + 0.3 < 0.981
    s = set_point(joint);
    CHECK(s.hunting == Hunting::no);
    CHECK(s.reason == SetPointReason::held);
    CHECK(s.rest_error == Approx((0.981 - 0.3) / 18));
    joint.control.integral_limit = infinity;
    joint.control.dead_zone = 1e-4;
    CHECK(set_point(joint).hunting == Hunting::yes);
    // the integral stops in the zone and goes on pushing: the mass is driven across, and hunts over more than the zone
    joint.control.dead_zone = 0.05;
    s = set_point(joint);
    CHECK(s.hunting == Hunting::yes);
    CHECK(s.rests_nearby);
    CHECK(s.amplitude == Approx(0.0837).epsilon(0.005));  // by Runge and Kutta in steps of 0.1 ms
    joint.control.dead_zone = 0.2;                        // still so, by Runge and Kutta in steps of 0.5 ms
    s = set_point(joint);
    CHECK(s.hunting == Hunting::yes);
    CHECK(s.rests_nearby);
    CHECK(s.amplitude == Approx(0.2336).epsilon(0.002));
    joint.control.dead_zone = 0.3;
    CHECK(set_point(joint).amplitude == Approx(0.33362).epsilon(1e-3));
}

TEST_CASE("with LuGre hunting ends where the slips are no longer than the bristles give", "[set-point]")
{
    const LuGre law{1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3};
    const auto soft = set_point(joint_of({1, 20, 100, 100}, law));
    REQUIRE(soft.hunting == Hunting::yes);
    CHECK(soft.method == SetPointMethod::presliding);
    // near the cycle that the same levels have with true rest
    CHECK(soft.amplitude == Approx(0.0023852).epsilon(0.05));
    const auto stiff = set_point(joint_of({1, 20, 1000, 1000}, law));
    CHECK(stiff.hunting == Hunting::no);
}

TEST_CASE("what is not judged at a set point says why", "[set-point][slow]")
{
    auto joint = joint_of({1, 2, 18, 30}, KineticStatic{0.327, 0.981});
    joint.control.kind = ControlKind::force;
    CHECK(set_point(joint).reason == SetPointReason::force_control);
    joint.control.kind = ControlKind::position;
    joint.control.k_i = 0;
    auto s = set_point(joint);
    CHECK(s.hunting == Hunting::no);
    CHECK(s.rest_error == Approx(0.981 / 18));
    joint.control.k_i = 37;  // 2 · 18 < 37
    CHECK(set_point(joint).reason == SetPointReason::loop_unstable);
    joint.friction.law = RateAndState{};
    CHECK(set_point(joint).hunting == Hunting::undecided);
}

TEST_CASE("a level of friction that moves by itself has no set point", "[set-point]")
{
    const auto joint = joint_of({1, 2, 18, 30}, KineticStatic{0.327, 0.981});
    REQUIRE(set_point(joint).hunting == Hunting::yes);
    const auto refused = [&](auto&& change) {
        Joint changed = joint;
        change(changed.friction);
        const auto s = set_point(changed);
        return s.hunting == Hunting::undecided && s.reason == SetPointReason::friction_term;
    };
    CHECK(refused([](Friction& f) { f.drift.change = 0.1; }));
    CHECK(refused([](Friction& f) { f.load_coefficient = 0.1; }));
    CHECK(refused([](Friction& f) { f.ripple.amplitude = 0.1; }));
    CHECK(refused([](Friction& f) { f.gear.backward = 0.5; }));
}

TEST_CASE("a set point is held in what the encoder says", "[set-point]")
{
    const auto law = KineticStatic{0.327, 0.981};
    Joint read = joint_of({1, 2, 18, 30}, law);
    read.sensor.position_scale = 2;
    const auto scaled = set_point(read), twice = set_point(joint_of({1, 4, 36, 60}, law));
    REQUIRE(scaled.hunting == Hunting::yes);
    CHECK(scaled.amplitude == Approx(twice.amplitude));
    CHECK(scaled.period == Approx(twice.period));
}

TEST_CASE("a load takes its share of the limits of a loop at a set point", "[set-point]")
{
    const PidMass loop{1, 2, 18, 30};
    const auto with = [&](double load, double integral, double effort) {
        Joint joint = joint_of(loop, KineticStatic{0.327, 0.981});
        joint.load.constant = load;
        joint.control.integral_limit = integral, joint.control.effort_limit = effort;
        return set_point(joint);
    };
    const double free = with(0, infinity, infinity).amplitude;
    CHECK(with(5, infinity, infinity).amplitude == Approx(free));
    CHECK(with(-5, 7, 9).amplitude == Approx(free));
    // 5 N pull one way: of 4 N of integral or output nothing is left against them, of 5.5 N less than static friction;
    // a simulation with the former rests, and hunts from 28 mm on one side to 35 mm on the other with the latter
    for (const double limit : {4.0, 5.5}) {
        CHECK(with(5, limit, infinity).hunting != Hunting::yes);
        CHECK(with(-5, infinity, limit).hunting != Hunting::yes);
    }
    Joint plain = joint_of({1, 2, 18, 0}, KineticStatic{0.327, 0.981});
    plain.load.constant = 5;
    CHECK(set_point(plain).rest_error == Approx(5.981 / 18));
    plain.control.effort_limit = 4.5;  // 5 − 4.5 is held by static friction while the joint rests, and no longer
    CHECK(set_point(plain).reason == SetPointReason::loaded);
    plain.control.effort_limit = 4;
    CHECK(set_point(plain).reason == SetPointReason::load_beyond_limits);
}

TEST_CASE("a slip from so near that forces are rounding ends, too", "[set-point]")
{
    // the integral creeps in for seconds while it and 2.7 N of static friction cancel to twelve digits
    Joint joint;
    joint.mechanism.inertia = 0.15;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 8300, c.k_v = 195, c.k_i = 12800;
    joint.friction.law = Stribeck{1.95, 1.9, 0.77, 7.2e-3, 2};
    const StopToStop motion(regulator_of(joint), joint.friction);
    for (const double a : {1e-3, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
        const auto stop = motion.slip_from(a);
        INFO("from " << a << " to " << stop.x);
        CHECK((stop.end == Stop::End::settled || stop.end == Stop::End::stop));
        CHECK(std::abs(stop.x) < a);
    }
    CHECK(set_point(joint).hunting == Hunting::no);
}

TEST_CASE("a slip of which only the creep into the set point is left ends there, however near it began", "[set-point]")
{
    // near rest the curve is as good as straight, and in closed form a slip ends within 10⁻⁸ of the set point
    const PidMass mass{.inertia = 1, .damping = 10 + 10, .k_p = 6e5, .k_i = 1e5};
    REQUIRE(std::abs(settling_multiplier(mass)) < 1e-8);
    Stribeck law;
    law.c0 = 60, law.c1 = 10, law.c2 = 6, law.c3 = 2e-3, law.c4 = 2;
    Joint joint = joint_of(mass, law);
    joint.control.k_v = 10;
    const StopToStop motion(regulator_of(joint), joint.friction);
    for (const double a : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-11}) {
        CAPTURE(a);
        CHECK(motion.slip_from(a).end == Stop::End::settled);
    }
    const auto answer = set_point(joint);
    CHECK(answer.hunting == Hunting::no);
    CHECK(answer.reason == SetPointReason::slips_shrink);
}

TEST_CASE("a limit that is out of reach changes nothing about how a slip ends", "[set-point]")
{
    // a ball-screw stage: the integral takes half a minute for what the damper takes milliseconds
    Joint joint;
    joint.mechanism.inertia = 38;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 5.2e6, c.k_v = 1.9e4, c.k_i = 1e5;
    joint.friction.law = Stribeck{34, 420, 11, 1.4e-3, 2};
    const auto free = set_point(joint);
    REQUIRE(free.hunting == Hunting::no);
    const StopToStop unlimited(regulator_of(joint), joint.friction);
    const auto limited = [&](auto&& limit) {
        Joint changed = joint;
        limit(changed.control);
        const StopToStop motion(regulator_of(changed), changed.friction);
        for (const double a : {1e-4, 1e-7, 1e-9, 1e-11}) {
            CAPTURE(a);
            const auto same = unlimited.slip_from(a), stop = motion.slip_from(a);
            CHECK(stop.end == Stop::End::settled);
            CHECK(stop.end == same.end);
        }
        CHECK(set_point(changed).hunting == free.hunting);
    };
    limited([](Control& k) { k.effort_limit = 900; });
    limited([](Control& k) { k.integral_limit = 600; });
    limited([](Control& k) { k.integral_band = 0.01; });
}

TEST_CASE("an integral that waits at the effort limit keeps the command on it", "[set-point]")
{
    // against equal steps of Euler, in which it winds up in one step and waits in the next
    Joint joint;
    joint.mechanism.inertia = 0.05;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 22, c.k_v = 0.5, c.k_i = 240, c.effort_limit = 9;
    const double coulomb = 0.8, viscous = 0.12;
    joint.friction.law = Stribeck{coulomb, viscous, 0.4, 0.05, 2};
    const auto by_euler = [&](double a) {
        const double h = 5e-7, breakaway = coulomb + 0.4;
        double x = -a, v = 0, w = breakaway - c.k_p * a, t = 0, way = 1;
        for (;;) {
            const double asked = -c.k_p * x - c.k_v * v + w, u = std::clamp(asked, -9.0, 9.0);
            const bool waits = u != asked && (c.anti_windup == AntiWindup::clamp || -x * asked > 0);
            const double friction = way * (coulomb + 0.4 * std::exp(-v * v / (0.05 * 0.05))) + viscous * v;
            w += waits ? 0 : -h * c.k_i * x;
            v += h * (u - friction) / joint.mechanism.inertia;
            x += h * v, t += h;
            if (way * v > 0 || t < 2 * h) continue;
            if (std::abs(u) <= breakaway) return std::pair(x, t);
            v = 0, way = std::copysign(1.0, u);
        }
    };
    for (const auto kind : {AntiWindup::clamp, AntiWindup::conditional}) {
        c.anti_windup = kind;
        for (const double a : {0.3, 1.78, 10.0}) {
            CAPTURE(a);
            const auto [x, t] = by_euler(a);
            const auto stop = StopToStop(regulator_of(joint), joint.friction).slip_from(a);
            REQUIRE(stop.end == Stop::End::stop);
            CHECK(stop.x == Approx(x).epsilon(1e-3));
            CHECK(stop.slip_time == Approx(t).epsilon(1e-4));
        }
    }
}
