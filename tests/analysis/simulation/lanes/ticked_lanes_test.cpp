// Lanes of sampled loops against the scalar simulation of the same loop, which has another integrator and finds the
// events of each step by itself; and that a point's bits depend on nothing but the point.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/lanes/ticked_batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <bit>

using namespace stickslip;

namespace {

template <class Change>
Joint changed(Joint joint, Change&& change)
{
    change(joint);
    return joint;
}

/// One of each thing that a loop can have.
std::vector<Joint> all_kinds()
{
    const Joint plain = ticked_joint(50e3), delayed = ticked_joint(60e3, 1e-3);
    return {
        plain,
        delayed,
        ticked_joint(90e3, 1e-3),
        ticked_joint(60e3, 0.4e-3),
        ticked_joint(50e3, 2.7e-3),
        changed(delayed, [](Joint& j) { j.actuator.lag = 2e-3; }),
        changed(delayed, [](Joint& j) { j.control.velocity_estimate.tau = 3e-3; }),
        changed(delayed, [](Joint& j) { j.control.velocity_estimate.average = 4; }),
        changed(delayed, [](Joint& j) { j.control.velocity_estimate.form = EstimateForm::exact; }),
        changed(delayed, [](Joint& j) { j.control.k_i = 1e5; }),
        changed(delayed, [](Joint& j) { j.control.effort_limit = 60.3; }),
        changed(delayed, [](Joint& j) { j.control.reference_velocity = false; }),
        changed(delayed, [](Joint& j) { j.load.constant = -5; }),
        changed(delayed, [](Joint& j) { j.friction.normal_load = 0.7; }),
        changed(ticked_joint(10e3),
                [](Joint& j) {
                    j.actuator.kind = ActuatorKind::dc_motor, j.actuator.signal = DriveSignal::voltage;
                    j.actuator.resistance = 2, j.actuator.k_t = 5, j.actuator.k_e = 5;
                }),
        changed(ticked_joint(50e3, 1e-3), [](Joint& j) { j.control.period = not_set; }),
        with_ageing(delayed),
        with_ageing(changed(delayed, [](Joint& j) { j.actuator.lag = 2e-3; })),
    };
}

std::vector<PointResult> points_of(std::span<const Joint> joints)
{
    std::vector<PointResult> rows;
    for (const auto& joint : joints) rows.push_back(linear_point(joint));
    nonlinear_points(joints, {}, rows);
    return rows;
}

bool same_bits(const PointResult& a, const PointResult& b)
{
    const auto same = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
    };
    return a.outcome == b.outcome && a.region == b.region && a.reason == b.reason && a.path == b.path &&
           same(a.amplitude, b.amplitude) && same(a.period, b.period) && same(a.velocity_min, b.velocity_min) &&
           same(a.velocity_max, b.velocity_max) && same(a.stick_fraction, b.stick_fraction) &&
           same(a.overshoot, b.overshoot) && same(a.growth_rate, b.growth_rate);
}

}  // namespace

TEST_CASE("ticked lanes: told cycles of the reference joint", "[lanes][sampled]")
{
    const Joint joints[] = {ticked_joint(60e3, 1e-3), ticked_joint(50e3), ticked_joint(67e3, 1e-3)};
    const auto rows = points_of(joints);
    for (const auto& row : rows) CHECK(row.path == DecisionPath::lanes);
    CHECK(rows[0].outcome == Outcome::limit_cycle);
    CHECK(rows[0].amplitude == Approx(18.1688e-6).epsilon(2e-5));
    CHECK(rows[0].period == Approx(96.615e-3).epsilon(1e-5));
    CHECK(std::log(rows[0].velocity_min / 1e-3) == Approx(-1.13878).margin(2e-5));
    CHECK(std::log(rows[0].velocity_max / 1e-3) == Approx(1.27205).margin(2e-5));
    CHECK(rows[1].amplitude == Approx(22.1829e-6).epsilon(1e-5));
    CHECK(rows[1].period == Approx(109.448e-3).epsilon(1e-5));
    CHECK(rows[2].outcome == Outcome::stable_sliding);
    CHECK(rows[2].reason == Reason::none);
}

TEST_CASE("ticked lanes: every kind of loop as the scalar simulation follows it", "[lanes][sampled][slow]")
{
    const auto joints = all_kinds();
    const auto rows = points_of(joints);
    int cycles = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        CAPTURE(i);
        const auto truth = nonlinear_verdict(joints[i], {});
        const auto& row = rows[i];
        CHECK(row.path == DecisionPath::lanes);
        CHECK(truth.path == DecisionPath::ticks);
        CHECK(row.outcome == truth.outcome);
        CHECK(row.reason == truth.reason);
        CHECK((row.region == Region::bistable) == (truth.region == NonlinearRegion::bistable));
        CHECK(row.growth_rate == Approx(truth.growth_rate).epsilon(1e-3));
        CHECK(std::isnan(row.amplitude) == std::isnan(truth.amplitude));
        if (std::isnan(truth.amplitude)) continue;
        ++cycles;
        CHECK(row.amplitude == Approx(truth.amplitude).epsilon(2e-5));
        CHECK(row.period == Approx(truth.period).epsilon(1e-5));
        CHECK(std::log(row.velocity_max / row.velocity_min) ==
              Approx(std::log(truth.velocity_max / truth.velocity_min)).epsilon(1e-4));
        CHECK(row.stick_fraction == Approx(truth.stick_fraction).margin(1e-4));
    }
    CHECK(cycles > 8);
}

TEST_CASE("ticked lanes: an encoder and noise are those of the scalar simulation", "[lanes][sampled][slow]")
{
    for (const bool noisy : {false, true}) {
        Joint joint = ticked_joint(60e3, 1e-3);
        (noisy ? joint.sensor.position_noise : joint.sensor.encoder_quantum) = 1e-7;
        const auto row = points_of({&joint, 1}).front();
        const auto truth = nonlinear_verdict(joint, {});
        CHECK(row.path == DecisionPath::lanes);
        CHECK(row.outcome == truth.outcome);
        CHECK(row.amplitude == Approx(truth.amplitude).epsilon(1e-2));
    }
}

TEST_CASE("ticked lanes: bits depend on the point alone", "[lanes][sampled][slow]")
{
    auto joints = all_kinds();
    const auto together = points_of(joints);
    std::reverse(joints.begin(), joints.end());
    const auto reversed = points_of(joints);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        CAPTURE(i);
        CHECK(same_bits(reversed[i], together[joints.size() - 1 - i]));
        if (i % 3 == 0) CHECK(same_bits(points_of({&joints[i], 1}).front(), reversed[i]));
    }
}

TEST_CASE("ticked lanes: what they do not cover is followed alone", "[lanes][sampled]")
{
    Joint loaded = ticked_joint(60e3, 1e-3);
    loaded.control.contact_stiffness = 1e3;
    CHECK(points_of({&loaded, 1}).front().path == DecisionPath::ticks);
    CHECK(!lanes::in_ticked_lanes(loaded));
    Joint sagging = ticked_joint(60e3, 1e-3);
    sagging.actuator.limit = 70;
    CHECK(!lanes::in_ticked_lanes(sagging));
}
