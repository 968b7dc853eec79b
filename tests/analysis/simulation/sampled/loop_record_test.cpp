// Records of a simulated loop: against the recursion of the interface written out here, and true sticking.
#include <catch2/catch.hpp>

#include "tests/analysis/simulation/sampled/sampled_joint.h"

using namespace stickslip;

TEST_CASE("loop record: the motion of coulomb friction, step by small step")
{
    const Joint joint = sampled_joint();
    const auto reference = swing(2, 1e-3);
    const auto record = record_along(joint, reference, 0);
    REQUIRE(record.reason == Reason::none);
    REQUIRE(record.time.size() == reference.time.size());
    // the same by semi-implicit Euler in 500 parts a tick, sticking included
    double q = 0, v = 0, estimate = 0, before = 0, worst = 0, worst_v = 0;
    std::vector<double> line(3, 0.0);
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        if (k > 0) estimate += 1e-3 / 4e-3 * ((q - before) / 1e-3 - estimate);
        before = q;
        line.erase(line.begin());
        line.push_back(4000 * (reference.position[k] - q) + 120 * (reference.velocity[k] - estimate));
        worst = std::max(worst, std::abs(record.position[k] - q));
        worst_v = std::max(worst_v, std::abs(record.velocity[k] - estimate));
        for (int i = 0; i < 500; ++i) {
            const double h = 1e-3 / 500;
            const double free = v + h / 2 * (line.front() - 10 * v);
            v = free - std::clamp(free, -h / 2 * 5, h / 2 * 5);
            q += h * v;
        }
    }
    CHECK(worst < 2e-6);
    CHECK(worst_v < 1e-4);
}

TEST_CASE("loop record: a late reading shows where the joint was, beside the effort of now")
{
    Joint joint = sampled_joint();
    joint.control.delay = 1e-3;
    joint.sensor.delay = 2.6e-3;
    joint.actuator.lag = 2e-3;
    const auto reference = swing(2, 1e-3);
    const auto record = record_along(joint, reference, 0);
    REQUIRE(record.reason == Reason::none);
    REQUIRE(record.effort_measured.size() == reference.time.size());
    // semi-implicit Euler in 500 parts a tick, with the positions of the last 2.6 ms kept as they were
    constexpr int parts = 500, read_after = 1300;  // parts
    double q = 0, v = 0, effort = 0, estimate = 0, before = 0, worst = 0, worst_effort = 0;
    std::vector<double> line(2, 0.0), been(read_after, 0.0);
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        const double reading = been[been.size() - read_after];
        if (k > 0) estimate += 1e-3 / 4e-3 * ((reading - before) / 1e-3 - estimate);
        before = reading;
        line.erase(line.begin());
        line.push_back(4000 * (reference.position[k] - reading) + 120 * (reference.velocity[k] - estimate));
        worst = std::max(worst, std::abs(record.position[k] - reading));
        worst_effort = std::max(worst_effort, std::abs(record.effort_measured[k] - effort));
        for (int i = 0; i < parts; ++i) {
            const double h = 1e-3 / parts, begun = effort;
            effort = line.front() + (effort - line.front()) * std::exp(-h / 2e-3);
            const double free = v + h / 2 * ((begun + effort) / 2 - 10 * v);
            v = free - std::clamp(free, -h / 2 * 5, h / 2 * 5);
            q += h * v;
            been.push_back(q);
        }
    }
    CHECK(worst < 2e-6);
    CHECK(worst_effort < 5e-2);
}

TEST_CASE("loop record: a set point under static friction is held, not crept away from")
{
    Joint joint = sampled_joint();
    KineticStatic law;
    law.kinetic = 4, law.breakaway = 6;
    joint.friction.law = law;
    joint.load.constant = 3;
    ReferenceMotion still{{0, 1, 2}, {0.01, 0.01, 0.01}, {0, 0, 0}, {}};
    const auto record = record_along(joint, still, 0);
    REQUIRE(record.reason == Reason::none);
    CHECK(record.position.back() == record.position[0]);
    CHECK(record.effort_command.back() == 0);
}

TEST_CASE("loop record: a drift comes with the time of the record, whatever the reference's clock shows")
{
    Joint joint = sampled_joint();
    joint.friction.drift = {-3, 0.5};
    auto reference = swing(2, 1e-3);
    const auto record = record_along(joint, reference, 0);
    REQUIRE(record.reason == Reason::none);
    for (double& t : reference.time) t += 64;
    const auto later = record_along(joint, reference, 0);
    REQUIRE(later.position.size() == record.position.size());
    double apart = 0;
    for (std::size_t k = 0; k < record.position.size(); ++k)
        apart = std::max(apart, std::abs(later.position[k] - record.position[k]));
    CHECK(apart < 1e-8);
}

TEST_CASE("loop record: noise is that of its seed")
{
    Joint joint = sampled_joint();
    joint.sensor.position_noise = 1e-5, joint.sensor.encoder_quantum = 1e-5;
    const auto reference = swing(0.5, 1e-3);
    const auto a = record_along(joint, reference, 3), b = record_along(joint, reference, 3),
               c = record_along(joint, reference, 4);
    CHECK(a.position == b.position);
    CHECK(a.position != c.position);
    CHECK(std::abs(std::remainder(a.position[100], 1e-5)) < 1e-12);
}

TEST_CASE("loop record: what cannot be followed is said")
{
    Joint joint = sampled_joint();
    RateAndState law;
    law.f0 = 5, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5), law.L.push_back(1e-5);
    joint.friction.law = law;
    const auto record = record_along(joint, swing(0.5, 1e-3), 0);
    CHECK(record.time.empty());
    CHECK(record.reason == Reason::law_needs_motion);
    // forwards, and back after half a second
    ReferenceMotion turn;
    for (int i = 0; i <= 1000; ++i) {
        turn.time.push_back(i * 1e-3);
        turn.position.push_back(0.25 - (turn.time.back() - 0.5) * (turn.time.back() - 0.5));
    }
    const auto turned = record_along(joint, turn, 0);
    CHECK(turned.reason == Reason::law_needs_motion);
    CHECK(turned.why == Detail::law_at_rest);
    REQUIRE(!turned.time.empty());
    CHECK(turned.time.back() > 0.45);
    CHECK(turned.time.back() < 0.6);
    CHECK(turned.effort_measured.size() == turned.time.size());
    joint = sampled_joint();
    joint.control.period = not_set;
    CHECK(record_along(joint, {{0, 0.1, 0.3}, {0, 1, 2}, {}, {}}, 0).reason == Reason::unsupported);
}
