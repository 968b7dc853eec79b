// Documents that are wrong in several numbers, or in one that a log shares.
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using stickslip::test::in_order;
using stickslip::test::Machine;

namespace {

std::vector<Record> two_records(const Machine& m)
{
    return {test::record_of(m, 1), test::record_of(m, 2)};
}

/// Logged as the current times the documented constant, of which the machine has `gain` times as much.
std::vector<Record> with_shared_constant(const Machine& m)
{
    auto records = two_records(m);
    for (auto& record : records)
        for (double& effort : record.effort_measured) effort /= m.gain;
    return records;
}

double value_of(const Cause& cause, std::string_view name)
{
    const auto number = std::ranges::find(cause.parameters, name, &FittedParameter::name);
    REQUIRE(number != cause.parameters.end());
    return number->value;
}

}  // namespace

TEST_CASE("inertia and Coulomb friction wrong by one factor are named, not a friction that grows with the load",
          "[gap][slow]")
{
    // effort = 1.3 (J a + F) + b v: a friction of 0.23 of the effort says the same with a number less
    Machine m;
    m.inertia *= 1.3, m.coulomb *= 1.3;
    const auto d = test::answer(test::nominal_joint(), two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    CHECK(std::ranges::count(named.names, "inertia") == 1);
    CHECK(std::ranges::count(named.names, "coulomb-level") == 1);
    CHECK(named.names.size() == 2);
    CHECK(value_of(named, "inertia.factor") == Approx(1.3).epsilon(0.01));
    CHECK(value_of(named, "coulomb-level.change") == Approx(0.6).epsilon(0.03));
}

TEST_CASE("a torque constant that a log of the current shares is named, not everything that it moves", "[gap][slow]")
{
    Machine m;
    m.gain = 1.1, m.effort_noise = 0.01;
    const auto d = test::answer(test::nominal_joint(), with_shared_constant(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"effort-gain"});
    CHECK(value_of(d.effects[0], "effort-gain.factor") == Approx(1.1).epsilon(0.005));
}

TEST_CASE("a torque constant that a log of the current shares is found beside another wrong number", "[gap][slow]")
{
    // corrections of every number by a seventh say the same, and would bend the inertia by it
    Machine m;
    m.gain = 0.86, m.inertia *= 0.77, m.effort_noise = 0.01;
    const auto d = test::answer(test::nominal_joint(), with_shared_constant(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    REQUIRE(std::ranges::is_permutation(named.names, std::vector<std::string>{"inertia", "effort-gain"}));
    CHECK(value_of(named, "effort-gain.factor") == Approx(0.86).epsilon(0.01));
    CHECK(value_of(named, "inertia.factor") == Approx(0.77).epsilon(0.01));
}

TEST_CASE("a torque constant beside a Coulomb level is no encoder with another scale", "[gap][slow]")
{
    // the scale of the position makes the same inertia and viscous friction of the logged effort
    Machine m;
    m.gain = 0.85, m.coulomb *= 0.81, m.effort_noise = 0.01;
    const auto d = test::answer(test::nominal_joint(), with_shared_constant(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    REQUIRE(std::ranges::is_permutation(named.names, std::vector<std::string>{"coulomb-level", "effort-gain"}));
    CHECK(value_of(named, "effort-gain.factor") == Approx(0.85).epsilon(0.005));
    CHECK(value_of(named, "coulomb-level.change") == Approx(-0.38).margin(0.01));
}

TEST_CASE("two wrong numbers are found over a torque constant that no log shows", "[gap][slow]")
{
    // with a constant as documented, inertia and gravity a fifth too low would say nearly the same
    Machine m;
    m.gain = 1.25, m.inertia *= 0.8, m.coulomb *= 1.3, m.gravity = 5, m.amplitude = 3;
    Joint joint = test::nominal_arm();
    joint.load.gravity_amplitude = 5;
    const auto d = test::answer(joint, two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    REQUIRE(
        std::ranges::is_permutation(named.names, std::vector<std::string>{"inertia", "coulomb-level", "effort-gain"}));
    CHECK(value_of(named, "effort-gain.factor") == Approx(1.25).epsilon(0.01));
    CHECK(value_of(named, "inertia.factor") == Approx(0.8).epsilon(0.01));
    CHECK(value_of(named, "coulomb-level.change") == Approx(0.6).margin(0.02));
}

TEST_CASE("a spring is found beside two wrong numbers of the document", "[gap][slow]")
{
    Machine m;
    m.hung = 0.5, m.hung_stiffness = 2500, m.hung_damping = 0.5, m.amplitude = 3;
    Joint joint = test::nominal_joint();
    joint.mechanism.inertia *= 1.3;
    std::get<CoulombViscous>(joint.friction.law).coulomb *= 0.6;
    const auto d = test::answer(joint, two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    REQUIRE(
        std::ranges::is_permutation(named.names, std::vector<std::string>{"inertia", "coulomb-level", "compliance"}));
    CHECK(value_of(named, "inertia.factor") == Approx(1 / 1.3).epsilon(0.01));
    CHECK(value_of(named, "coulomb-level.change") == Approx(0.8).epsilon(0.02));
    CHECK(value_of(named, "compliance.stiffness") == Approx(2500).epsilon(0.05));
}

TEST_CASE("three wrong numbers are no spring, where slow motion hardly shows the inertia", "[gap][slow]")
{
    Machine m;
    m.gravity = 6;
    Joint joint = test::nominal_arm();
    joint.mechanism.inertia *= 2;
    joint.load.gravity_amplitude = 9;
    std::get<CoulombViscous>(joint.friction.law).coulomb *= 0.7;
    const auto d = test::answer(joint, two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    for (const auto& name : d.effects[0].names) UNSCOPED_INFO(name << " " << d.effects[0].probability);
    CHECK(std::ranges::is_permutation(d.effects[0].names,
                                      std::vector<std::string>{"inertia", "coulomb-level", "gravity"}));
}

TEST_CASE("a Coulomb level too low and a viscous slope too high are no Stribeck curve", "[gap][slow]")
{
    // over the speeds of a record the friction that is missing falls as a wide peak does
    Machine m;
    m.coulomb = 2.8, m.viscous = 0.9, m.noise = 2e-5;
    const auto d = test::answer(test::nominal_joint(), two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    for (const auto& name : named.names) UNSCOPED_INFO(name << " " << named.probability);
    REQUIRE(std::ranges::is_permutation(named.names, std::vector<std::string>{"coulomb-level", "viscous"}));
    CHECK(value_of(named, "coulomb-level.change") == Approx(0.8).margin(0.05));
}

TEST_CASE("a small Stribeck peak is no pair of wrong numbers", "[gap][slow]")
{
    Machine m;
    m.peak = 0.5, m.noise = 2e-5;
    const auto d = test::answer(test::nominal_joint(), two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    for (const auto& name : d.effects[0].names) UNSCOPED_INFO(name << " " << d.effects[0].probability);
    CHECK(d.effects[0].names == std::vector<std::string>{"stribeck"});
}

TEST_CASE("gravity that is documented with the wrong sign is named", "[gap][slow]")
{
    Machine m;
    m.gravity = 5;
    Joint joint = test::nominal_arm();
    joint.load.gravity_amplitude = -5;
    const auto d = test::answer(joint, two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"gravity"});
}

namespace {

/// One slow slide in one direction: Coulomb friction and a constant load are one number in it.
Record one_way(const Machine& m, unsigned seed)
{
    Record r;
    r.name = "one-way-" + std::to_string(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    test::MachineState now;
    double estimate = 0, last = 0;
    constexpr double period = 1e-3, h = 1e-5;
    for (int k = 0; k < 6000; ++k) {
        const double t = k * period, wave = 2 + 0.3 * seed;
        const double reference = 0.02 * (t - std::sin(wave * t) / wave), rate = 0.02 * (1 - std::cos(wave * t));
        const double y = m.quantum * std::round((now.q + m.noise * normal(random)) / m.quantum);
        if (k > 0) estimate += period / (m.tau + period) * ((y - last) / period - estimate);
        last = y;
        const double u = m.k_p * (reference - y) + m.k_v * (rate - estimate);
        r.time.push_back(t), r.position.push_back(y), r.velocity.push_back(estimate), r.effort_command.push_back(u);
        r.reference_position.push_back(reference), r.reference_velocity.push_back(rate);
        for (int i = 0; i < 100; ++i) test::step(m, now, u, t + i * h, h);
    }
    return r;
}

}  // namespace

TEST_CASE("what one direction of sliding cannot divide is told as wide as the document leaves it", "[gap][slow]")
{
    Machine m;
    m.coulomb *= 1.1;
    const auto d = test::answer(test::nominal_joint(), {one_way(m, 1), one_way(m, 2)}, in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto& named = d.effects[0];
    REQUIRE(named.names == std::vector<std::string>{"coulomb-level", "constant-load"});
    // both numbers have a prior of 5 % of the Coulomb level; the records give their difference alone
    const double prior = 0.05 * 2, along = prior / std::sqrt(2.0);
    for (const auto& parameter : named.parameters) CHECK(parameter.standard_error == Approx(along).epsilon(0.1));
    CHECK(d.ambiguous_with == std::vector<std::vector<std::string>>{{"constant-load"}, {"coulomb-level"}});
}

TEST_CASE("numbers that are all wrong by one factor are a rival of the torque constant that says the same",
          "[gap][slow]")
{
    Machine m;
    m.inertia *= 1.25, m.coulomb *= 1.25, m.viscous *= 1.25, m.effort_noise = 0.01;
    m.load = 0.15;  // a correction beside either
    const auto d = test::answer(test::nominal_joint(), two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto is_listed = [&](std::vector<std::string> names) {
        return std::ranges::any_of(d.effects,
                                   [&](const Cause& cause) { return std::ranges::is_permutation(cause.names, names); });
    };
    CHECK(is_listed({"effort-gain"}));
    CHECK(is_listed({"coulomb-level", "inertia", "viscous"}));
}

TEST_CASE("friction that differs by direction is told beside the constant load that makes the same motion",
          "[gap][slow]")
{
    Machine m;
    m.load = -0.4, m.coulomb *= 1.2;
    const auto d = test::answer(test::nominal_joint(), two_records(m), in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    const auto has = [](const std::vector<std::string>& names, const char* name) {
        return std::ranges::count(names, name) > 0;
    };
    CHECK((has(d.effects[0].names, "constant-load") || has(d.effects[0].names, "asymmetric-friction")));
    const bool other = std::ranges::any_of(d.ambiguous_with, [&](const auto& names) {
        return has(names, "constant-load") != has(d.effects[0].names, "constant-load") &&
               has(names, "asymmetric-friction") != has(d.effects[0].names, "asymmetric-friction");
    });
    CHECK(other);
}
