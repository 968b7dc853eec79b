// At which side of a gear gains are counted: every verb that judges a loop says it.
#include "analysis/joint/loop_side.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/report/pages/boundary_report.h"
#include "sweep/report/pages/design_report.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/margins_text.h"
#include "sweep/words/verdict_text.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Contains;

namespace {

Joint geared(double ratio)
{
    Joint joint;
    auto& m = joint.mechanism;
    m.motion = Motion::revolute, m.model = Model::two_mass;
    m.motor_inertia = 3e-4, m.link_inertia = 0.03;
    m.transmission.stiffness = 100, m.transmission.damping = 0.02, m.transmission.ratio = ratio;
    joint.control.k_p = 60, joint.control.k_v = 1, joint.control.V0 = 0.05;
    joint.frictions.motor.law = joint.frictions.link.law = CoulombViscous{0.1, 0.02};
    return joint;
}

std::vector<std::string> texts(const Joint& joint)
{
    BoundaryAnswer boundary;
    boundary.design = joint, boundary.loop = verdict_loop(joint), boundary.region = Region::stable;
    DesignAnswer design;
    design.joint = joint, design.loop = verdict_loop(joint);
    design.design.decided = design.design.feasible = true;
    DesignAnswer none = design;
    none.design.feasible = false;
    return {verdict_text(joint, linear_verdict(joint)), boundary_report(boundary).verdict,
            margins_text(margins_of(joint)), design_verdict_text(design), design_verdict_text(none)};
}

}  // namespace

TEST_CASE("Verdicts, boundaries, margins and designs of a geared joint say at which side they count", "[words][gear]")
{
    const std::string side = "gains and efforts are at the joint side of the gear of 10:1";
    for (const auto& text : texts(geared(10))) CHECK_THAT(text, Contains(side) && Contains("100 times smaller"));
    for (const auto& text : texts(geared(1))) CHECK_THAT(text, !Contains("gear"));
    // a loop that reads the link pushes the motor all the same
    Joint link = geared(10);
    link.control.feedback = Feedback::link;
    for (const auto& text : texts(link)) CHECK_THAT(text, Contains(side) && Contains("is 10 times smaller"));
}

TEST_CASE("The loop of JSON answers names the gear and the side at which they count", "[words][gear]")
{
    const auto gear = loop_json(verdict_loop(geared(10)))["gear"];
    CHECK(gear["ratio"] == 10);
    CHECK(gear["counted_at"] == "joint");
    CHECK(gear["k_p_per_record"] == 100);
    CHECK_THAT(gear["text"].get<std::string>(), Contains("joint side of the gear of 10:1"));
    CHECK(loop_json(verdict_loop(geared(1)))["gear"].is_null());
    // volts stay volts: k_p N per displacement, not N²
    Joint motor = geared(10);
    auto& a = motor.actuator;
    a.kind = ActuatorKind::dc_motor, a.k_t = a.k_e = 0.1, a.resistance = 2;
    CHECK(with_loop_at_joint(motor).control.k_p == 10 * motor.control.k_p);
    CHECK(gear_side(motor).gain == 10);
    CHECK_THAT(loop_text(loop_use(motor)), Contains("k_{p} is 10 times smaller") &&
                                               Contains("k_{t} and k_{e} are the joint's as well: 10 times those"));
    CHECK_THAT(side_text(gear_side(motor), true), Contains("10 times as large and so are k_{t} and k_{e}"));
    CHECK_THAT(loop_text(loop_use(geared(10))), !Contains("k_{t}"));
}
