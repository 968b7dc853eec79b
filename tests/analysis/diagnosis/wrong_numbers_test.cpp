// Documents that are wrong in several numbers, or in one that a log shares.
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using stickslip::test::in_order;
using stickslip::test::Machine;

namespace {

std::vector<Record> two_records(const Machine& m)
{
    return {test::record_of(m, 1), test::record_of(m, 2)};
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
    auto records = two_records(m);
    for (auto& record : records)
        for (double& effort : record.effort_measured) effort /= m.gain;
    const auto d = test::answer(test::nominal_joint(), records, in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"effort-gain"});
    CHECK(value_of(d.effects[0], "effort-gain.factor") == Approx(1.1).epsilon(0.005));
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
