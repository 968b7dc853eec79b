// Reductions: exact where they claim it, and their error where they do not.
#include <catch2/catch.hpp>

#include "analysis/joint/reduction.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/reduction_error.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

TEST_CASE("lever and three masses are the same linear system", "[joint]")
{
    auto lever = samples::nine_states();
    lever.mechanism.model = Model::lever;
    lever.mechanism.lever_arm = 0.3;
    lever.mechanism.motor_transmission.ratio = 5;
    const auto reduced = lever_to_three_mass(lever);
    const auto before = spectrum(linear_joint(lever, 1e-3)), after = spectrum(linear_joint(reduced.joint, 1e-3));
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) CHECK(std::abs(before[i] - after[i]) < 1e-9 * std::abs(before[i]));
    CHECK_THROWS_AS(lever_to_three_mass(reduced.joint), std::invalid_argument);
}

TEST_CASE("three masses become two as the neglected spring stiffens", "[joint]")
{
    for (const auto placement : {Placement::at_motor, Placement::at_joint}) {
        double last = infinity;
        for (const double stiffness : {1e7, 1e8, 1e9, 1e10}) {
            auto joint = samples::three_mass();
            joint.mechanism.motor_transmission.ratio = 2;
            joint.frictions.transmission.law = CoulombViscous{0, 0};
            auto& spring = placement == Placement::at_motor ? joint.mechanism.motor_transmission
                                                            : joint.mechanism.transmission_link;
            spring.stiffness = stiffness;
            const auto compared = compare_reduction(
                joint, [&](const Joint& j) { return three_mass_to_two_mass(j, placement); }, "control.k_p", 1e3, 1e6);
            CAPTURE(stiffness);
            REQUIRE(compared.full.size() == 1);
            CHECK(compared.error < 0.3 * last);
            last = compared.error;
        }
        CHECK(last < 1e-5);
    }
}

TEST_CASE("an ideal motor is the limit of a stiff loop, a rigid transmission that of a soft one", "[joint]")
{
    // 7a: k_tr is the spring that k_cr is about. The motor's loop far stiffer and damped
    auto joint = samples::two_mass();
    joint.control.k_p = 1e10;
    joint.control.k_v = 1e6;
    joint.mechanism.transmission.damping = 0;
    auto compared = compare_reduction(joint, two_mass_to_single_mass, "joint.transmission.stiffness", 1e3, 1e6);
    REQUIRE(compared.reduced.size() == 1);
    CHECK(compared.reduced[0] == Approx(55000).epsilon(1e-9));
    CHECK(compared.error < 1e-4);
    // with a loop only ten times as stiff as the spring the reduction is a tenth off
    joint.control.k_p = 5.5e5;
    joint.control.k_v = 0;
    compared = compare_reduction(joint, two_mass_to_single_mass, "joint.transmission.stiffness", 1e3, 1e7);
    CHECK(compared.error > 0.05);

    auto rigid = samples::two_mass();
    rigid.frictions.motor.law = CoulombViscous{0, 0};
    compared = compare_reduction(rigid, rigid_transmission, "control.k_p", 1e3, 1e6);
    REQUIRE(compared.reduced.size() == 1);
    CHECK(compared.reduced[0] == Approx(57500).epsilon(1e-9));
    CHECK(compared.error < 0.02);
}

TEST_CASE("every reduction says what it neglects", "[joint]")
{
    CHECK_FALSE(two_mass_to_single_mass(samples::two_mass()).neglected.empty());
    auto two = samples::two_mass();
    two.frictions.motor.law = CoulombViscous{1, 2};
    CHECK(rigid_transmission(two).joined.size() == 1);  // no viscous part in rate-and-state
    two.frictions.motor.law = CoulombViscous{0, 0};
    CHECK_FALSE(rigid_transmission(two).neglected.empty());
    auto three = samples::three_mass();
    CHECK_FALSE(three_mass_to_two_mass(three, Placement::at_motor).neglected.empty());
    // two laws with memory on one body have no common law, but act side by side
    three.frictions.transmission = three.frictions.link;
    CHECK(three_mass_to_two_mass(three, Placement::at_joint).joined.size() == 1);
    // room is that of one body
    auto& law = std::get<RateAndState>(three.frictions.transmission.law);
    while (law.B.size < max_states) law.B.push_back(0.1), law.L.push_back(1e-4);
    CHECK_THROWS_AS(three_mass_to_two_mass(three, Placement::at_joint), std::invalid_argument);
    TimeLag delayed;
    delayed.lag = 1e-3;
    three.frictions.transmission.law = three.frictions.motor.law = delayed;
    CHECK_THROWS_AS(three_mass_to_two_mass(three, Placement::at_motor), std::invalid_argument);
}

TEST_CASE("joints with a law of its own on each body are reduced as the neglected spring stiffens", "[joint]")
{
    // the oracle is the full joint: three rate-and-state laws, two of which meet on one body without a common law
    const auto at = [](Placement placement) {
        return [placement](const Joint& j) { return three_mass_to_two_mass(j, placement); };
    };
    for (const auto placement : {Placement::at_motor, Placement::at_joint}) {
        double last = infinity;
        for (const double stiffness : {1e8, 1e10}) {
            auto joint = samples::nine_states();
            joint.mechanism.motor_transmission.ratio = 3;
            auto& spring = placement == Placement::at_motor ? joint.mechanism.motor_transmission
                                                            : joint.mechanism.transmission_link;
            spring.stiffness = stiffness;
            REQUIRE(at(placement)(joint).joined.size() == 1);
            const auto compared = compare_reduction(joint, at(placement), "control.k_p", 1e3, 1e7);
            CAPTURE(stiffness, compared.full, compared.reduced);
            REQUIRE_FALSE(compared.full.empty());
            CHECK(compared.error < 0.05 * last);
            last = compared.error;
        }
        CHECK(last < 1e-4);
    }
    // and on to one mass, everything rigid: what met on the motor goes on to the link
    auto rigid = samples::nine_states();
    rigid.mechanism.motor_transmission.ratio = 3;
    rigid.mechanism.motor_transmission.stiffness = rigid.mechanism.transmission_link.stiffness = 1e11;
    const auto both = [&](const Joint& j) { return in_sequence(at(Placement::at_motor)(j), rigid_transmission); };
    REQUIRE(both(rigid).joined.size() == 2);
    const auto compared = compare_reduction(rigid, both, "control.k_p", 1e3, 1e7);
    REQUIRE_FALSE(compared.full.empty());
    CHECK(compared.error < 1e-4);
    // an ideal motor takes what it carries with it
    CHECK(in_sequence(at(Placement::at_motor)(rigid), two_mass_to_single_mass).joined.empty());
}

TEST_CASE("frictions that move as one add up in sliding", "[joint]")
{
    for (const FrictionLaw& law : {FrictionLaw(samples::rate_and_state<RateAndState>()),
                                   FrictionLaw(Stribeck{10, 5, 4, 1e-2, 2}), FrictionLaw(CoulombViscous{3, 4})}) {
        auto joint = samples::two_mass();
        joint.mechanism.transmission.ratio = 3;
        joint.frictions.motor.law = CoulombViscous{2, info(law).needs_motion ? 0.0 : 0.5};
        joint.frictions.link.law = law;
        const auto one = rigid_transmission(joint).joint.friction;
        for (const double V : {1e-4, 1e-2})
            CHECK(steady_force(one, V) ==
                  Approx(3 * steady_force(joint.frictions.motor, 3 * V) + steady_force(joint.frictions.link, V)));
        // the same inside out: the law at the motor keeps its numbers only without a reduction
        std::swap(joint.frictions.motor, joint.frictions.link);
        if (!std::holds_alternative<CoulombViscous>(law)) {
            const auto beside = rigid_transmission(joint);
            REQUIRE(beside.joined.size() == 1);
            CHECK(beside.joined[0].turns == 3);
            CHECK(steady_force(beside.joined[0].friction, 1e-3) == steady_force(joint.frictions.motor, 1e-3));
        }
        joint.mechanism.transmission.ratio = 1;
        const auto other = rigid_transmission(joint).joint.friction;
        CHECK(steady_force(other, 1e-3) ==
              Approx(steady_force(joint.frictions.motor, 1e-3) + steady_force(joint.frictions.link, 1e-3)));
    }
}
