// Set points of loops that are sampled, late, limited and loaded, against records of the same joint along a reference.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/sampled/loop_record.h"
#include "analysis/simulation/set_point/set_point.h"

using namespace stickslip;

namespace {

constexpr double pi = 3.14159265358979323846;

/// The second published loop of set_point_test.cpp: stops 2.3952231 mm to either side of the set point.
Joint published(double period, double delay, double breakaway = 1.5)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 100, c.k_v = 20, c.k_i = 100;
    c.period = period, c.delay = delay;
    c.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = KineticStatic{1, breakaway};
    return joint;
}

Joint arm(double k_i)
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute;
    joint.mechanism.inertia = 0.3;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 450, c.k_v = 5, c.k_i = k_i;
    joint.friction.law = KineticStatic{0.5, 3.3};
    return joint;
}

/// Positions of the joint that is commanded to 0 from rest at `start`.
std::vector<double> held_from(const Joint& joint, double start, double duration)
{
    constexpr double row = 1e-3;
    ReferenceMotion reference;
    for (int i = 0; i * row <= duration; ++i) {
        reference.time.push_back(i * row);
        reference.position.push_back(i == 0 ? start : 0);
        reference.velocity.push_back(0);
    }
    return record_along(joint, reference, 0).position;
}

/// Mean time from one passage of 0 upwards to the next, of the later half.
double period_of_late(const std::vector<double>& x)
{
    constexpr double row = 1e-3;
    std::vector<double> passages;
    for (std::size_t i = x.size() / 2; i < x.size(); ++i)
        if (x[i - 1] < 0 && x[i] >= 0) passages.push_back(row * static_cast<double>(i));
    REQUIRE(passages.size() > 2);
    return (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

double largest_of_late(const std::vector<double>& x, double share)
{
    double most = 0;
    for (std::size_t i = static_cast<std::size_t>((1 - share) * static_cast<double>(x.size())); i < x.size(); ++i)
        most = std::max(most, std::abs(x[i]));
    return most;
}

}  // namespace

TEST_CASE("a late loop that is unstable while it moves holds no set point", "[set-point]")
{
    for (const double breakaway : {1.0, 1.5}) {
        const Joint late = published(0.01, 0.15, breakaway);
        const auto s = set_point(late);
        CHECK(s.hunting == Hunting::no);
        CHECK(s.reason == SetPointReason::loop_unstable);
        CHECK(largest_of_late(held_from(late, 1, 10), 0.1) > 1e3);
    }
    Joint without = published(0.01, 0.3);
    without.control.k_i = 0;
    CHECK(set_point(without).diverges());
    CHECK(largest_of_late(held_from(without, 1, 10), 0.1) > 1e3);
}

TEST_CASE("hunting of a sampled, late loop is that of its record", "[set-point][slow]")
{
    for (const double delay : {0.0, 0.004, 0.0085}) {
        Joint joint = published(1e-3, delay);  // with the gains of the first published loop: cycles of 3 s
        auto& c = joint.control;
        c.k_p = 18, c.k_v = 2, c.k_i = 30;
        joint.friction.law = KineticStatic{0.327, 0.981};
        const auto s = set_point(joint);
        CAPTURE(delay, s.amplitude);
        REQUIRE(s.hunting == Hunting::yes);
        CHECK(s.method == SetPointMethod::simulated);
        CHECK(s.reason == SetPointReason::static_above_coulomb);
        const auto x = held_from(joint, 2 * s.amplitude, 40 * s.period);
        CHECK(s.amplitude == Approx(largest_of_late(x, 0.3)).epsilon(0.01));
        // a stop lasts until the command is there, and has come through the dead time
        CHECK(s.period == Approx(period_of_late(x)).epsilon(1e-3));
    }
    // and in ticks that are short beside all that it does that of the loop without ticks
    const auto fine = set_point(published(1e-4, 0));
    CHECK(fine.amplitude == Approx(0.0023952231).epsilon(2e-3));
    CHECK(fine.period == Approx(21.747516).epsilon(2e-3));
}

TEST_CASE("a stable late loop settles where static friction equals Coulomb friction", "[set-point]")
{
    const Joint joint = published(1e-3, 0.02, 1);
    const auto s = set_point(joint);
    CHECK(s.hunting == Hunting::no);
    CHECK(s.reason == SetPointReason::static_is_coulomb);
    CHECK(s.largest_ratio < 1);
    const auto x = held_from(joint, 0.05, 60);
    CHECK(std::abs(x.back()) < 0.05 * largest_of_late(x, 1));
}

TEST_CASE("gravity pulls at a set point as a constant load of its size does", "[set-point]")
{
    Joint pulled = arm(0), loaded = arm(0);
    pulled.load.gravity_amplitude = 20, pulled.load.gravity_phase = pi / 2;
    loaded.load.constant = -20;
    const auto s = set_point(pulled), l = set_point(loaded);
    CHECK(l.rest_error == Approx((20 + 3.3) / 450));
    CHECK(s.rest_error == Approx(l.rest_error).epsilon(2e-3));  // by the cosine of 3°
    const double rest = std::abs(held_from(pulled, 0, 5).back());
    CHECK(rest <= s.rest_error);
    CHECK(rest > (20 - 3.3) / 450);
    // fed forward it pulls no more
    pulled.control.feed_forward.gravity = true;
    CHECK(set_point(pulled).rest_error == Approx(3.3 / 450).epsilon(1e-3));
    CHECK(std::abs(held_from(pulled, 0, 5).back()) <= 3.3 / 450);
}

TEST_CASE("a load that the limits cannot hold is not held by any integral", "[set-point][slow]")
{
    Joint joint = arm(100);
    joint.load.gravity_amplitude = 20, joint.load.gravity_phase = pi / 2;
    joint.control.effort_limit = 10;
    const auto s = set_point(joint);
    CHECK(s.hunting == Hunting::no);
    CHECK(s.reason == SetPointReason::load_beyond_limits);
    CHECK(s.diverges());
    CHECK(largest_of_late(held_from(joint, 0, 10), 0.1) > 0.5);
    joint.control.effort_limit = 200;
    CHECK(set_point(joint).hunting == Hunting::yes);
    CHECK(largest_of_late(held_from(joint, 0, 30), 0.3) < 0.1);
}

TEST_CASE("an encoder step is a dead zone of a late loop", "[set-point]")
{
    Joint joint = published(1e-3, 0);
    joint.sensor.encoder_quantum = 1e-3;
    const auto s = set_point(joint);
    REQUIRE(s.hunting == Hunting::yes);
    CHECK(s.rests_nearby);
    // the record has what the encoder reads, half a step more at most
    CHECK(std::abs(s.amplitude - largest_of_late(held_from(joint, 0.01, 100), 0.8)) <= 0.51e-3);
}

TEST_CASE("what no answer at a set point has a place for leaves it undecided where it matters", "[set-point]")
{
    Joint joint = arm(100);
    REQUIRE(set_point(joint).hunting == Hunting::yes);
    joint.load.disturbance.amplitude = 0.01, joint.load.disturbance.frequency = 10;
    CHECK(set_point(joint).hunting == Hunting::yes);
    joint.load.disturbance.amplitude = 1;
    auto s = set_point(joint);
    CHECK(s.reason == SetPointReason::left_out);
    CHECK(s.not_used == std::vector<std::string>{"load.disturbance.amplitude"});
    joint = arm(100);
    joint.sensor.position_noise = 0.01;
    CHECK(set_point(joint).reason == SetPointReason::left_out);
    joint = arm(100);
    joint.control.delay = 1e-3;
    joint.friction.law = LuGre{1e5, 300, 0.4, 1, 1.5, 1e-3};
    CHECK(set_point(joint).reason == SetPointReason::loop_not_simulated);
}
