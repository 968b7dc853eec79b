// An encoder that reads another number per displacement: the loop follows V_0 by its reading, and the joint slides at
// V_0 per that number. Every answer is of sliding there.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/design/design.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/motion_measures.h"
#include "analysis/simulation/sampled/loop_record.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

constexpr double c0 = 0.3, c1 = 0.02, c2 = 0.25, c3 = 0.05, k_p = 60, commanded = 0.05, scale = 5;

/// f_ss of the law, in closed form.
double friction_at(double V)
{
    return c0 + c1 * V + c2 * std::exp(-std::pow(V / c3, 2));
}

double slope_at(double V)
{
    return c1 - 2 * c2 * V / (c3 * c3) * std::exp(-std::pow(V / c3, 2));
}

Joint scaled_joint()
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute, joint.mechanism.inertia = 0.05;
    joint.control.k_p = k_p, joint.control.k_v = 1, joint.control.V0 = commanded;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate = {EstimateForm::backward_difference, 3e-3};
    joint.friction.law = Stribeck{c0, c1, c2, c3, 2};
    joint.sensor.position_scale = scale;
    return joint;
}

/// The same machine with an encoder that reads displacements, and gains that are as large per displacement.
Joint unscaled(Joint joint)
{
    joint.control.V0 /= scale;
    joint.control.k_p *= scale, joint.control.k_v *= scale;
    joint.sensor.position_scale = 1;
    return joint;
}

}  // namespace

TEST_CASE("Friction, deflection, slope and limits are those of the velocity at which a scaled encoder lets it slide",
          "[stability][steady]")
{
    Joint joint = scaled_joint();
    const double V = commanded / scale, f = friction_at(V);
    const auto verdict = linear_verdict(joint);
    CHECK(verdict.steady.velocity == commanded);
    CHECK(verdict.steady.slides_at == V);
    CHECK(verdict.steady.friction == Approx(f).epsilon(1e-12));
    CHECK(verdict.steady.deflection == Approx(f / k_p).epsilon(1e-12));
    CHECK(verdict.velocity_only.slope == Approx(slope_at(V)).epsilon(1e-12));
    // between the friction at V_0 and the one at V_0 per scale
    joint.control.effort_limit = 0.5;
    REQUIRE(friction_at(commanded) < joint.control.effort_limit);
    REQUIRE(f > joint.control.effort_limit);
    CHECK(possible_sliding(joint).reason == Reason::limit_too_low);
    CHECK(linear_point(joint).reason == Reason::limit_too_low);
}

TEST_CASE("A record of a scaled encoder ends in the steady sliding that evaluate reports", "[stability][steady]")
{
    const Joint joint = scaled_joint();
    ReferenceMotion ramp;
    for (int i = 0; i <= 4000; ++i) {
        ramp.time.push_back(1e-3 * i);
        ramp.position.push_back(commanded * ramp.time.back());
    }
    const auto record = record_along(joint, ramp, 0);
    REQUIRE(record.reason == Reason::none);
    const auto steady = steady_sliding(joint);
    CHECK(record.effort_measured.back() == Approx(steady.friction).epsilon(1e-6));
    CHECK(record.reference_position.back() - record.position.back() == Approx(steady.deflection).epsilon(1e-6));
}

TEST_CASE("Boundaries, ranges of velocities and designs of a scaled encoder are those of the machine without it",
          "[stability][steady]")
{
    Joint scaled = scaled_joint();
    const Joint plain = unscaled(scaled);
    const double per = scale;
    BoundaryRequest request;
    request.kind = BoundaryKind::state_variable;
    Axis velocities{"control.V0", "V_{0}", "", Quantity::velocity, true, {1e-3, 10}};
    const auto found = locate_boundaries(scaled, velocities, request);
    for (double& v : velocities.values) v /= per;
    const auto expected = locate_boundaries(plain, velocities, request);
    REQUIRE(expected.points.size() == 2);
    REQUIRE(found.points.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(found.points[i].value == Approx(per * expected.points[i].value).epsilon(1e-6));

    const auto range = velocity_gain_for_range(scaled, per * 0.2, 60), same = velocity_gain_for_range(plain, 0.2, 60);
    CHECK(range.velocity == Approx(per * same.velocity).epsilon(1e-3));
    CHECK(per * range.k_v == Approx(same.k_v).epsilon(1e-6));
}

TEST_CASE("A force loop slides where its ramp says, whatever an encoder reads", "[stability][steady]")
{
    Joint joint = scaled_joint();
    joint.control.kind = ControlKind::force, joint.control.period = not_set, joint.control.velocity_estimate = {};
    joint.control.force_gain = 0.5;
    for (const double lag : {0.0, 1e-3}) {
        joint.actuator.lag = lag;
        Joint plain = joint;
        plain.sensor.position_scale = 1;
        CHECK(steady_sliding(joint).slides_at == commanded);
        CHECK(growth_rate(joint) == Approx(growth_rate(plain)).epsilon(1e-9));
    }
}

TEST_CASE("The overshoot of a scaled encoder is that of the machine without it, per the same displacement",
          "[stability][steady]")
{
    Joint scaled = scaled_joint();
    scaled.control.V0 = scale * 0.01, scaled.control.k_v = 0.1;  // sticks and slips
    for (const double period : {1e-3, not_set}) {
        scaled.control.period = period;
        if (!is_set(period)) scaled.control.velocity_estimate = {};
        const auto found = nonlinear_verdict(scaled, {}), expected = nonlinear_verdict(unscaled(scaled), {});
        REQUIRE(expected.overshoot > 0);
        CHECK(found.amplitude == Approx(expected.amplitude).epsilon(1e-3));
        CHECK(found.overshoot == Approx(expected.overshoot).epsilon(1e-3));
    }
    // and a step of it overshoots by as much
    ReferenceMotion step, same;
    for (int i = 0; i <= 3000; ++i) {
        for (auto* r : {&step, &same}) r->time.push_back(1e-3 * i);
        same.position.push_back(i < 10 ? 0 : 0.5);
        step.position.push_back(scale * same.position.back());
    }
    scaled = scaled_joint();
    const auto record = record_along(scaled, step, 0), plain = record_along(unscaled(scaled), same, 0);
    const auto m = measure_motion(plain.time, plain.reference_position, plain.position);
    const auto read = measure_motion(record.time, record.reference_position, record.position);
    REQUIRE(m.overshoot > 0);
    CHECK(per_reading(read, scale).overshoot == Approx(m.overshoot).epsilon(1e-4));
    CHECK(per_reading(read, scale).final_error == Approx(m.final_error).epsilon(1e-3).margin(1e-6));
}
