// What a controller adds against dry friction, tick by tick: pushes that follow velocity or error, and dither, against
// the same motion in small equal steps, and the energy of a shaken joint.
#include <catch2/catch.hpp>

#include "analysis/loop/loop_use.h"
#include "analysis/simulation/sampled/loop_trajectory.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/simulation/sampled/unsteady_terms.h"
#include "analysis/simulation/set_point/set_point.h"
#include "tests/analysis/simulation/sampled/sampled_joint.h"

using namespace stickslip;

namespace {

double pushed(const Control& c, double rate, double v, double e)
{
    const auto& f = c.feed_forward;
    if (f.coulomb_from == CoulombFrom::reference) return f.coulomb * std::tanh(rate / f.coulomb_speed);
    if (f.coulomb_from == CoulombFrom::velocity) return f.coulomb * std::tanh(v / f.coulomb_speed);
    const double side =
        e == 0 ? 0 : std::max(-1.0, std::min(1.0, f.coulomb_width > 0 ? e / f.coulomb_width : 1e300 * e));
    return f.coulomb * side * (1 - std::tanh(std::abs(v) / f.coulomb_speed));
}

/// The largest difference to semi-implicit Euler in 500 parts a tick, sticking included.
double worst_difference(const Joint& joint, const ReferenceMotion& reference, const LoopRecord& record)
{
    const auto& c = joint.control;
    double q = reference.position[0], v = 0, estimate = 0, before = q, worst = 0;
    std::vector<double> line(3, 0.0);
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        if (k > 0) estimate += 1e-3 / 4e-3 * ((q - before) / 1e-3 - estimate);
        before = q;
        const double e = reference.position[k] - q;
        line.erase(line.begin());
        line.push_back(c.k_p * e + c.k_v * (reference.velocity[k] - estimate) +
                       pushed(c, reference.velocity[k], estimate, e) +
                       c.dither.amplitude * std::sin(c.dither.frequency * record.time[k]));
        worst = std::max(worst, std::abs(record.position[k] - q));
        for (int i = 0; i < 500; ++i) {
            const double h = 1e-3 / 500;
            const double free = v + h / 2 * (line.front() - 10 * v);
            v = free - std::clamp(free, -h / 2 * 5, h / 2 * 5);
            q += h * v;
        }
    }
    return worst;
}

/// A mass that stands at a distance from its set point and is held there for a while.
LoopRecord released(const Joint& joint, double distance, double seconds)
{
    ReferenceMotion r;
    for (int k = 0; k * 1e-3 <= seconds; ++k) {
        r.time.push_back(k * 1e-3);
        r.position.push_back(k == 0 ? -distance : 0);
        r.velocity.push_back(0);
    }
    return record_along(joint, r, 0);
}

}  // namespace

TEST_CASE("a push of reference, velocity or error, and dither: step by small step", "[push]")
{
    const auto reference = swing(1.5, 1e-3, 0.25);
    for (const auto from : {CoulombFrom::reference, CoulombFrom::velocity, CoulombFrom::error})
        for (const double dither : {0.0, 8.0}) {
            Joint joint = sampled_joint();
            auto& f = joint.control.feed_forward;
            f.coulomb = 3, f.coulomb_from = from, f.coulomb_speed = 0.05, f.coulomb_width = 1e-3;
            joint.control.dither = {dither, 300};
            const auto record = record_along(joint, reference, 0);
            REQUIRE(record.reason == Reason::none);
            CHECK(worst_difference(joint, reference, record) < 3e-6);
        }
}

TEST_CASE("dither below the kinetic friction lets all motion die, nearer than without it", "[push][set-point]")
{
    Joint joint = sampled_joint();
    joint.control.delay = 0, joint.control.velocity_estimate.tau = 0;
    joint.friction.law = KineticStatic{5, 7};
    for (const double amplitude : {0.0, 2.0, 4.0}) {
        joint.control.dither = {amplitude, 400};
        const auto s = set_point(joint);
        REQUIRE(s.hunting == Hunting::no);
        CHECK(s.rest_error == Approx((7 - amplitude) / 4000));
        CHECK(s.reason == (amplitude > 0 ? SetPointReason::dither_narrows : SetPointReason::no_integral_action));
        // released further away than it can rest: it stands still in the end, within that band
        const auto record = released(joint, 1.2 * 7 / 4000, 2);
        REQUIRE(record.reason == Reason::none);
        CHECK(std::abs(record.position.back()) <= s.rest_error);
        CHECK(record.position.back() == Approx(record.position[record.position.size() - 500]).epsilon(1e-12));
        // and where it may rest for ever it does: nothing moves from just inside
        const auto still = released(joint, 0.99 * s.rest_error, 1);
        CHECK(still.position.back() == Approx(-0.99 * s.rest_error).epsilon(1e-12));
        // but not just outside
        const auto moved = released(joint, 1.01 * s.rest_error, 1);
        CHECK(std::abs(moved.position.back()) < 1.005 * s.rest_error);
    }
    joint.control.dither = {7.5, 400};  // more than the static friction: it shakes for ever
    CHECK(set_point(joint).reason == SetPointReason::dithered);
    const auto shaken = released(joint, 1e-4, 2);
    CHECK(std::abs(shaken.position.back() - shaken.position[shaken.position.size() - 4]) > 1e-9);
    joint.control.dither.amplitude = 4, joint.control.k_i = 1000;
    CHECK(set_point(joint).reason == SetPointReason::dithered);
}

TEST_CASE("pushes by the error and dither are said to be left out of the linear theory", "[push]")
{
    Joint joint = sampled_joint();
    joint.control.V0 = 0.02;
    const auto left_out = [&](const char* key) -> std::optional<UnusedTerm> {
        for (const auto& term : loop_use(joint).not_used)
            if (term.key == key) return term;
        return {};
    };
    auto& f = joint.control.feed_forward;
    f.coulomb = 3, f.coulomb_speed = 0.05;
    REQUIRE(left_out("control.feed_forward"));
    CHECK_FALSE(left_out("control.feed_forward.coulomb_from"));
    f.coulomb_from = CoulombFrom::velocity;
    CHECK_FALSE(left_out("control.feed_forward.coulomb_from"));
    const auto used = loop_use(joint).used;
    CHECK(std::count(used.begin(), used.end(), "control.feed_forward.coulomb_from") == 1);
    f.coulomb_from = CoulombFrom::error, f.coulomb_width = 1;
    REQUIRE(left_out("control.feed_forward.coulomb_from"));
    CHECK(left_out("control.feed_forward.coulomb_from")->matters);
    f.coulomb_speed = 1e-4;  // at V_0 the push has faded
    CHECK_FALSE(left_out("control.feed_forward.coulomb_from")->matters);
    joint.control.dither = {1, 300};
    REQUIRE(left_out("control.dither"));
    CHECK(left_out("control.dither")->matters);
    CHECK(has_unsteady_terms(joint));
}

TEST_CASE("a push of the measured velocity is a negative damping of its slope", "[push]")
{
    // about V_0 the loop with the push is the loop with k_v less by its slope: same growth
    Joint joint = sampled_joint();
    joint.control.V0 = 0.02;
    joint.friction.law = Stribeck{};
    auto& law = std::get<Stribeck>(joint.friction.law);
    law.c0 = 5, law.c1 = 10, law.c2 = 2, law.c3 = 0.03, law.c4 = 2;
    auto plain = joint;
    auto& f = joint.control.feed_forward;
    f.coulomb = 3, f.coulomb_speed = 0.05, f.coulomb_from = CoulombFrom::velocity;
    const double share = std::tanh(0.02 / 0.05);
    plain.control.k_v -= 3 * (1 - share * share) / 0.05;
    const auto pushed = loop_verdict(joint, {}), less = loop_verdict(plain, {});
    CHECK(pushed.growth_rate == Approx(less.growth_rate).epsilon(1e-4));
    CHECK(pushed.growth_rate != Approx(loop_verdict(sampled_joint(), {}).growth_rate).epsilon(1e-2));
}

TEST_CASE("a push that jumps by more than sliding takes leaves no steady sliding", "[push]")
{
    Joint joint = sampled_joint();
    joint.control.V0 = 1e-4;
    auto& f = joint.control.feed_forward;
    f.coulomb = 8, f.coulomb_from = CoulombFrom::error, f.coulomb_speed = 1;
    const auto chatters = loop_verdict(joint, {});
    CHECK(chatters.reason == Reason::no_steady_state);
    CHECK(chatters.detail == Detail::chatters);
    const Trajectory path = loop_trajectory(joint, {});
    CHECK(path.reason == Reason::no_steady_state);  // no limit is in its way
    CHECK(path.why == Detail::chatters);
    f.coulomb_width = 1e-2;
    CHECK(loop_verdict(joint, {}).reason == Reason::none);
    f.coulomb = 3, f.coulomb_width = 0;
    CHECK(loop_verdict(joint, {}).reason == Reason::none);
}
