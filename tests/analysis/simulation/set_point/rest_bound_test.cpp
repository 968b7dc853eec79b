// How far from its set point a joint may rest behind an encoder and a dead zone, against records from either side of
// it.
#include <algorithm>
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/loop_record.h"
#include "analysis/simulation/set_point/set_point.h"

using namespace stickslip;

namespace {

Joint regulated(double k_i, double dead_zone)
{
    Joint joint;
    joint.mechanism.inertia = 5.025;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 2351, c.k_v = 176.2, c.k_i = k_i, c.period = 5e-4, c.dead_zone = dead_zone;
    c.velocity_estimate.form = EstimateForm::backward_difference, c.velocity_estimate.tau = 1e-3;
    joint.friction.law = Stribeck{2.936, 6.998, 2.188, 0.01681, 2};
    joint.sensor.encoder_quantum = 1.73e-4;
    return joint;
}

/// Whether its reading changes when it is released there.
bool moves(const Joint& joint, double start, double duration)
{
    ReferenceMotion reference;
    for (int i = 0; i * joint.control.period <= duration; ++i) {
        reference.time.push_back(i * joint.control.period);
        reference.position.push_back(i == 0 ? start : 0);
        reference.velocity.push_back(0);
    }
    const auto x = record_along(joint, reference, 0).position;
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    return *least != *most;
}

}  // namespace

TEST_CASE("a rest lies within the last encoder step in the dead zone and half a step", "[set-point][slow]")
{
    constexpr double hair = 1e-3;
    for (const double zone : {0.0, 1e-4, 1.73e-4, 2.15e-4, 4e-4})
        for (const double k_i : {3919.0, 0.0}) {
            CAPTURE(zone, k_i);
            const Joint joint = regulated(k_i, zone);
            const auto s = set_point(joint);
            REQUIRE(s.hunting == Hunting::no);
            const double duration = k_i > 0 ? 30 : 2;  // the integral winds slowly
            CHECK_FALSE(moves(joint, (1 - hair) * s.rest_error, duration));
            CHECK(moves(joint, (1 + hair) * s.rest_error, duration));
        }
}
