// What a joint at a set point does from where: starts that rest, hunt and diverge, against records from those places.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/sampled/loop_record.h"
#include "analysis/simulation/set_point/set_point.h"

using namespace stickslip;

namespace {

/// Friction whose curve is flat at v = 0.
Stribeck gaussian(double c0, double c1, double c2, double c3)
{
    Stribeck law;
    law.c0 = c0, law.c1 = c1, law.c2 = c2, law.c3 = c3, law.c4 = 2;
    return law;
}

Joint regulated(double inertia, double k_p, double k_v, double k_i, double period, double tau, const Stribeck& law)
{
    Joint joint;
    joint.mechanism.inertia = inertia;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = k_p, c.k_v = k_v, c.k_i = k_i, c.period = period;
    c.velocity_estimate.form = EstimateForm::backward_difference, c.velocity_estimate.tau = tau;
    joint.friction.law = law;
    return joint;
}

Joint fast_axis()
{
    return regulated(0.1259, 752.7, 9.306, 4949, 1e-3, 2e-3, gaussian(6.564, 2.272, 2.181, 0.03788));
}

Joint small_slide()
{
    return regulated(0.004329, 9.073, 0.177, 59.4, 2e-3, 4e-3, gaussian(0.0192, 0.005761, 0.01519, 0.01762));
}

/// Its loop is unstable: dry friction alone keeps it from diverging.
Joint lagging_stage()
{
    Joint joint = regulated(1.083, 15600, 79.17, 263800, 5e-4, 2.5e-3, gaussian(86.78, 4.194, 37.87, 0.01166));
    joint.control.delay = 5e-4;
    joint.actuator.lag = 2.5e-3;
    joint.sensor.encoder_quantum = 6.71e-4;
    return joint;
}

LoopRecord held_from(const Joint& joint, double start, double duration)
{
    const double row = is_set(joint.control.period) ? joint.control.period : 1e-3;
    ReferenceMotion reference;
    for (int i = 0; i * row <= duration; ++i) {
        reference.time.push_back(i * row);
        reference.position.push_back(i == 0 ? start : 0);
        reference.velocity.push_back(0);
    }
    return record_along(joint, reference, 0);
}

/// Of its last fifth.
double late_distance(const LoopRecord& record)
{
    double most = 0;
    for (std::size_t i = record.position.size() * 4 / 5; i < record.position.size(); ++i)
        most = std::max(most, std::abs(record.position[i]));
    return most;
}

/// A place in the middle of a range, on a logarithmic scale.
double middle(const StartRange& range)
{
    return std::sqrt(range.from * range.to);
}

}  // namespace

TEST_CASE("friction that is flat at rest lets small slips creep home: from nearby it rests", "[set-point][slow]")
{
    Joint continuous = small_slide();
    continuous.control.period = not_set;
    continuous.control.velocity_estimate = {};
    for (const Joint& joint : {fast_axis(), small_slide(), continuous}) {
        const auto s = set_point(joint);
        REQUIRE(s.hunting == Hunting::yes);
        CHECK(s.rests_nearby);
        REQUIRE(s.by_start.size() > 1);
        const auto &near = s.by_start[0], &beyond = s.by_start[1];
        REQUIRE(near.end == StartEnd::rests);
        REQUIRE(beyond.end == StartEnd::hunts);
        CHECK(s.rests_within() == near.to);
        const double duration = 12 * s.period;
        CHECK(late_distance(held_from(joint, middle(near), duration)) < 0.05 * s.amplitude);
        CHECK(late_distance(held_from(joint, near.to, duration)) < 0.05 * s.amplitude);
        CHECK(std::abs(late_distance(held_from(joint, middle(beyond), duration)) / s.amplitude - 1) < 0.02);
        // the quick question keeps the kind of place
        const auto quick = set_point(joint, quick_set_point);
        CHECK(quick.hunting == s.hunting);
        CHECK(quick.rests_nearby == s.rests_nearby);
    }
}

TEST_CASE("a loop that diverges from far away hunts from nearby where friction bounds it", "[set-point][slow]")
{
    const Joint joint = lagging_stage();
    const auto s = set_point(joint);
    CHECK(s.hunting == Hunting::yes);
    CHECK(s.diverges());
    CHECK(s.reason == SetPointReason::loop_unstable);
    REQUIRE(is_set(s.diverges_from()));
    const double slip = late_distance(held_from(joint, 8e-3, 10));
    CHECK(slip > 0.5 * s.amplitude);
    CHECK(slip < 1.5 * s.amplitude);
    CHECK(late_distance(held_from(joint, 10 * s.diverges_from(), 10)) > 1e3 * s.diverges_from());
}
