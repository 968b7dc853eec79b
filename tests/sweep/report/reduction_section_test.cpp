// What the section about reductions says of several of them, each thing once.
#include "sweep/report/pages/reduction_section.h"

#include <catch2/catch.hpp>

#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;
using Catch::Contains;

TEST_CASE("what one reduction neglects is said where it is a part of what another does", "[report]")
{
    ReductionStudy first, second;
    first.neglected = {"damping of the motor and of the link"};
    second.neglected = {"damping of the motor", "damping of the motor and of the link"};
    const auto section = reduction_section(samples::two_mass(), {first, second});
    CHECK_THAT(section.text, Contains("Neglected: damping of the motor and of the link; damping of the motor."));
}

TEST_CASE("every reduction that does not apply is named, each reason once", "[report]")
{
    ReductionStudy chain, step, other;
    chain.name = "two masses to one, ideal motor", step.name = "two masses to one", other.name = "three masses to two";
    chain.refused = step.refused = "the transmission has play";
    other.refused = "the link has no friction";
    const auto section = reduction_section(samples::two_mass(), {chain, step, step, other});
    CHECK_THAT(
        section.text,
        Contains("Not applicable (two masses to one, ideal motor, two masses to one): the transmission has play.") &&
            Contains("Not applicable (three masses to two): the link has no friction."));
}
