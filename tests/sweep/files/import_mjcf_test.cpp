// What actuators, springs, tendons and options of MJCF make of a joint, against MuJoCo's rule: force = gain · command +
// bias, clamped to forcerange, times the gear; and what is reported because a joint of ours has no place for it.
#include <catch2/catch.hpp>

#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/import_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/robot_table.h"
#include "sweep/study/import/arm_load.h"
#include "tests/temporary_directory.h"

#include <cmath>
#include <fstream>

using namespace stickslip;

namespace {

/// A beam of 2 kg that lies along x at zero: 9.81 · 2 · 0.5 N·m about the hinge at its end, inertia 0.66833 kg·m².
struct Beam {
    std::string joint, body, geom, actuators, before, after;

    std::string text() const
    {
        return "<mujoco><compiler angle=\"radian\"/>\n" + before + "\n<worldbody><body name=\"b\" " + body +
               ">\n<joint name=\"j\" axis=\"0 1 0\" " + joint + "/>\n<geom type=\"box\" size=\".5 .05 .05\" " +
               "pos=\".5 0 0\" mass=\"2\" " + geom + "/></body></worldbody>\n<actuator>" + actuators + "</actuator>\n" +
               after + "</mujoco>";
    }
};
const double inertia = 2 * (1 + 0.01) / 12 + 2 * 0.25, weight = 9.81 * 2 * 0.5;

ImportAnswer imported(const Beam& beam, const std::string& joint = "j")
{
    const TemporaryDirectory room;
    const auto file = room.path() / "beam.xml";
    std::ofstream(file) << beam.text();
    const Robot robot = read_robot(file);
    return import_joint(robot, joint_named(robot, joint, "beam.xml"), read_pose(robot, {}));
}

ImportAnswer driven(const std::string& actuators)
{
    Beam beam;
    beam.actuators = actuators;
    return imported(beam);
}

std::string joined(const ImportAnswer& answer)
{
    std::string text;
    for (const auto& of : answer.not_taken) text += of.element + ": " + of.attributes + "\n";
    return text;
}

}  // namespace

TEST_CASE("import: a motor's command is limited before its gear and its force behind it")
{
    const auto force = driven(R"(<motor joint="j" gear="100" forcerange="-1 1"/>)").joint;
    CHECK(force.actuator.effort_gain == 100);
    CHECK(force.actuator.limit == 100);
    CHECK(force.control.effort_limit == infinity);
    for (const char* limited : {"", "ctrllimited=\"true\"", "ctrllimited=\"auto\""}) {
        const auto command =
            driven("<motor joint=\"j\" gear=\"150\" ctrlrange=\"-1 1\" " + std::string(limited) + "/>").joint;
        CHECK(command.actuator.effort_gain == 150);
        CHECK(command.control.effort_limit == 1);
        CHECK(command.actuator.limit == infinity);
    }
    const auto general = driven(R"(<general joint="j" gear="2" gainprm="100" biasprm="0 -100 0"/>)");
    CHECK(general.joint.actuator.effort_gain == 200);
    CHECK(general.missing == std::vector<std::string>{"control.k_p"});
    Beam total{.joint = R"(actuatorfrcrange="-7 7")", .actuators = R"(<motor joint="j" gear="100"/>)"};
    CHECK(imported(total).joint.actuator.limit == 7);
    CHECK(imported(total).joint.control.effort_limit == infinity);
}

TEST_CASE("import: ranges that are not limits do not limit")
{
    for (const char* off : {"false", "auto"}) {
        INFO(off);
        const std::string state = off;
        Beam beam;
        if (state == "auto") beam.before = "<compiler autolimits=\"false\"/>";
        beam.joint = "actuatorfrcrange=\"-7 7\" actuatorfrclimited=\"" + state + "\"";
        beam.actuators = "<position joint=\"j\" kp=\"100\" forcerange=\"-3 3\" forcelimited=\"" + state + "\"/>";
        CHECK(imported(beam).joint.control.effort_limit == infinity);
        beam.actuators = "<motor joint=\"j\" ctrlrange=\"-3 3\" ctrllimited=\"" + state + "\"/>";
        CHECK(imported(beam).joint.control.effort_limit == infinity);
        CHECK(imported(beam).joint.actuator.limit == infinity);
    }
    Beam unclamped{.actuators = R"(<motor joint="j" ctrlrange="-3 3"/>)",
                   .before = R"(<option><flag clampctrl="disable"/></option>)"};
    CHECK(imported(unclamped).joint.control.effort_limit == infinity);
    Beam several{.actuators = R"(<position joint="j" kp="90" forcerange="-3 3"/><velocity joint="j" kv="5"/>)"};
    CHECK(imported(several).joint.control.effort_limit == infinity);
    CHECK(joined(imported(several)) == "position: forcerange=\"-3 3\"\n");
}

TEST_CASE("import: a limit that differs between the directions is the wider one, and reported")
{
    const auto motor = driven(R"(<motor joint="j" gear="-2" ctrlrange="-1 3" forcerange="-5 2"/>)");
    CHECK(motor.joint.control.effort_limit == 3);
    CHECK(motor.joint.actuator.limit == 10);
    CHECK(joined(motor) == "motor: ctrlrange=\"-1 3\"\nmotor: forcerange=\"-5 2\"\n");
    CHECK(motor.not_taken.at(0).reason == NotTakenReason::lopsided);
    const auto servo = driven(R"(<position joint="j" kp="9" ctrlrange="-1 3" forcerange="0 4"/>)");
    CHECK(servo.joint.control.effort_limit == 4);
    CHECK(joined(servo) == "position: forcerange=\"0 4\"\n");
    const Beam total{.joint = R"(actuatorfrcrange="-7 6")", .actuators = R"(<motor joint="j"/>)"};
    CHECK(imported(total).joint.actuator.limit == 7);
    CHECK(joined(imported(total)) == "joint: actuatorfrcrange=\"-7 6\"\n");
    CHECK(joined(driven(R"(<motor joint="j" forcerange="-5 2" forcelimited="false"/>)")).empty());
}

TEST_CASE("import: the range of a filter's output is a limit behind the lag")
{
    const std::string filtered = R"(<general joint="j" gear="3" gainprm="10" dyntype="filterexact" dynprm=".02" )";
    const auto limit = [&](const std::string& words) { return driven(filtered + words + "/>").joint.actuator.limit; };
    CHECK(limit(R"(actrange="-.5 .5")") == 15);
    CHECK(limit(R"(actrange="-.5 .5" forcerange="-4 4")") == 12);
    CHECK(limit(R"(actrange="-.5 .5" actlimited="false")") == infinity);
    CHECK(driven(R"(<motor joint="j" actrange="-1 1"/>)").joint.actuator.limit == infinity);  // nothing is filtered
    CHECK(joined(driven(R"(<position joint="j" kp="3" timeconst=".1" actrange="-1 1"/>)")) ==
          "position: timeconst=\".1\" actrange=\"-1 1\"\n");
}

TEST_CASE("import: what is wrong in an included file is told with its line there")
{
    const TemporaryDirectory room;
    const auto main = room.path() / "arm.xml";
    std::ofstream(main) << "<mujoco>\n<worldbody><include file=\"part.xml\"/></worldbody>\n</mujoco>";
    const auto told = [&](const std::string& part) {
        std::ofstream(room.path() / "part.xml") << part;
        try {
            read_robot(main);
        } catch (const BadInput& bad) {
            return std::string(bad.what());
        }
        return std::string();
    };
    const auto place = (room.path() / "part.xml").string();
    CHECK_THAT(told("<x>\n<body>\n<joint name=\"j\" axis=\"0 1\"/></body></x>"),
               Catch::StartsWith(place + ":3: <joint \"j\">: axis"));
    CHECK_THAT(told("<x>\n<body>\n<joint"), Catch::StartsWith(place + ":3: is not XML"));
    std::ofstream(room.path() / "inner.xml") << "<x>\n\n\n<joint name=\"j\" type=\"wheel\"/></x>";
    CHECK_THAT(told("<x><body><include file=\"inner.xml\"/></body></x>"),
               Catch::StartsWith((room.path() / "inner.xml").string() + ":4: "));
}

TEST_CASE("import: servos of one joint add up, and k_v knows which of them have a target velocity")
{
    const std::string position = R"(<position joint="j" kp="100" gear="2"/>)",
                      velocity = R"(<velocity joint="j" kv="5"/>)";
    for (const auto& both : {velocity + position, position + velocity}) {
        const auto control = driven(both).joint.control;
        CHECK(control.k_p == 400);
        CHECK(control.k_v == 5);
        CHECK(control.reference_velocity);
    }
    const auto damped = driven(R"(<position joint="j" kp="100" kv="3"/>)").joint.control;
    CHECK(damped.k_v == 3);
    CHECK_FALSE(damped.reference_velocity);
    const auto mixed = driven(R"(<position joint="j" kp="100" kv="3"/>)" + velocity).joint.control;
    CHECK(mixed.k_v == 8);
    CHECK(mixed.feed_forward.velocity == Approx(5. / 8));
    const auto affine = driven(R"(<general joint="j" biastype="affine" gainprm="70" biasprm="0 -70 -4"/>)"
                               R"(<general joint="j" biastype="affine" gainprm="6" biasprm="0 0 -6"/>)");
    CHECK(affine.joint.control.k_p == 70);
    CHECK(affine.joint.control.k_v == 10);
    CHECK(affine.not_taken.empty());
    const auto alone = driven(velocity);
    CHECK(alone.joint.control.k_v == 5);
    CHECK(alone.joint.actuator.effort_gain == 1);
    CHECK(alone.missing == std::vector<std::string>{"control.k_p"});
}

TEST_CASE("import: a damping ratio is k_v by the inertia where the robot stands as drawn")
{
    const auto k_v = [](const std::string& actuator) { return driven(actuator).joint.control.k_v; };
    CHECK(k_v(R"(<position joint="j" kp="100" dampratio="1"/>)") == Approx(2 * std::sqrt(100 * inertia)));
    CHECK(k_v(R"(<general joint="j" biastype="affine" gainprm="100" biasprm="0 -100 0.7"/>)") ==
          Approx(1.4 * std::sqrt(100 * inertia)));
    // the gear counts twice in k_p and in an actuator's own armature: M/g² behind it
    CHECK(k_v(R"(<position joint="j" kp="100" dampratio=".5" gear="2" armature=".02"/>)") ==
          Approx(std::sqrt(400 * (inertia + 0.08))));
    CHECK(driven(R"(<position joint="j" kp="1" gear="2" armature=".02" damping=".3"/>)").joint.mechanism.inertia ==
          Approx(inertia + 0.08));
    CHECK(driven(R"(<position joint="j" kp="1" gear="2" damping=".3"/>)").described.damping == Approx(1.2));
}

TEST_CASE("import: classes state attributes for actuators of every element, as MuJoCo reads them")
{
    Beam beam;
    beam.before = R"(<default><general forcerange="-3 3" gainprm="50"/>
        <default class="c"><position kp="40" kv="2"/></default></default>)";
    const auto with = [&](const std::string& actuators) {
        beam.actuators = actuators;
        return imported(beam).joint;
    };
    const auto position = with(R"(<position joint="j" class="c"/>)").control;
    CHECK(position.k_p == 40);
    CHECK(position.k_v == 2);
    CHECK(position.effort_limit == 3);
    CHECK(with(R"(<position joint="j"/>)").control.k_p == 50);
    CHECK(with(R"(<general joint="j" class="c"/>)").control.k_v == 2);
    const auto motor = with(R"(<motor joint="j" class="c"/>)").actuator;
    CHECK(motor.effort_gain == 1);
    CHECK(motor.limit == 3);
}

TEST_CASE("import: filters and delays are a motor's lag and dead time; those of a servo's target are reported")
{
    const auto motor = driven(R"(<general joint="j" dyntype="filterexact" dynprm="0.02" delay="0.01" nsample="9"/>)");
    CHECK(motor.joint.actuator.lag == 0.02);
    CHECK(motor.joint.control.delay == 0.01);
    CHECK(motor.not_taken.empty());
    const auto servo = driven(R"(<position joint="j" kp="100" kv="3" timeconst="0.01" delay="0.02"/>)");
    CHECK(servo.joint.actuator.lag == 0);
    CHECK(servo.joint.control.delay == 0);
    CHECK(joined(servo) == "position: timeconst=\"0.01\" delay=\"0.02\"\n");
    CHECK_THAT(import_text(servo, "beam.xml", ""),
               Catch::Contains("beam.xml:6: <position> (timeconst=\"0.01\" delay=\"0.02\") filters or delays"));
}

TEST_CASE("import: weight that the description takes off the bodies does not load the joint")
{
    CHECK(imported({}).dynamics.gravity_effort == Approx(weight));
    for (const double share : {1.0, 0.3}) {
        Beam beam{.body = "gravcomp=\"" + std::to_string(share) + "\""};
        CHECK(imported(beam).joint.load.gravity_amplitude == Approx((1 - share) * weight).margin(1e-12));
        CHECK(imported(beam).dynamics.inertia == Approx(inertia));
        beam.joint = "type=\"slide\"";
        beam.joint += " ref=\"0\"";
        auto text = beam.text();
        const TemporaryDirectory room;
        std::ofstream(room.path() / "up.xml") << text.replace(text.find("0 1 0"), 5, "0 0 1");
        const Robot robot = read_robot(room.path() / "up.xml");
        CHECK(axis_dynamics(robot, 0, {0}).gravity_effort == Approx(-(1 - share) * 2 * 9.81).margin(1e-12));
        CHECK(inverse_dynamics(robot, {0}, {0}, {0})[0] == Approx((1 - share) * 2 * 9.81).margin(1e-12));
    }
    Beam off{.before = R"(<option><flag gravity="disable"/></option>)"};
    CHECK(imported(off).dynamics.gravity_effort == 0);
    off.before = R"(<option><flag frictionloss="disable" damper="disable"/></option>)";
    off.joint = R"(damping="3" frictionloss="2")";
    CHECK(imported(off).described.damping == 0);
    CHECK(imported(off).described.friction == 0);
}

TEST_CASE("import: geoms of other groups have no part in the inertia")
{
    Beam beam{.geom = "group=\"1\"/><geom type=\"sphere\" size=\".1\" pos=\"2 0 0\" mass=\"5\" group=\"3\"",
              .before = R"(<compiler inertiagrouprange="0 1"/>)"};
    CHECK(imported(beam).dynamics.inertia == Approx(inertia));
    beam.before = R"(<compiler inertiagrouprange="0 5"/>)";
    CHECK(imported(beam).dynamics.inertia == Approx(inertia + 5 * (4 + 0.4 * 0.01)));
}

TEST_CASE("import: springs, curved damping and media are reported with place and attributes")
{
    Beam beam{.joint = R"(stiffness="30" springref="0.5" damping="1 2 3")", .before = R"(<option density="1.2"/>)"};
    const auto answer = imported(beam);
    CHECK(answer.described.damping == 1);
    CHECK(joined(answer) ==
          "option: density=\"1.2\"\njoint: stiffness=\"30\" springref=\"0.5\"\njoint: damping=\"1 2 3\"\n");
    CHECK_THAT(import_text(answer, "beam.xml", ""), Catch::Contains("beam.xml:4: <joint \"j\"> (stiffness=\"30\""));
    beam.before = R"(<option><flag spring="disable"/></option>)";
    beam.joint = R"(stiffness="30")";
    CHECK(imported(beam).not_taken.empty());
    beam.before = "";
    beam.joint = R"(springdamper="0.1 1" damping="2")";  // MuJoCo computes both coefficients and drops those that stand
    CHECK(imported(beam).described.damping == 0);
    CHECK(joined(imported(beam)) == "joint: springdamper=\"0.1 1\"\n");
}

TEST_CASE("import: actuators that a joint cannot express are reported for the joints on which they act")
{
    const std::string tip =
        "/><site name=\"s\"/><body name=\"tip\"><inertial mass=\"1\" pos=\".1 0 0\" "
        "diaginertia=\".1 .1 .1\"/><joint name=\"k\" axis=\"0 1 0\"/><site name=\"t\"/></body><geom "
        "mass=\"0\" size=\".01\"";
    const auto reported = [&](const std::string& actuator, const std::string& joint) {
        const Beam beam{
            .geom = tip, .actuators = actuator, .after = R"(<tendon><fixed name="f"><joint joint="k" coef="2"/></fixed>
                                    <spatial name="w"><site site="s"/><site site="t"/></spatial></tendon>)"};
        return imported(beam, joint).not_taken.size();
    };
    for (const char* on_j :
         {R"(<muscle joint="j"/>)", R"(<damper joint="j" kv="2" ctrlrange="0 1"/>)",
          R"(<cylinder joint="j" area="2"/>)", R"(<motor site="s"/>)",
          R"(<general joint="j" biastype="affine" gainprm="70" biasprm="0 -60 -4"/>)",
          R"(<general joint="j" biastype="affine" gainprm="70" biasprm="1 -70 -4"/>)",
          R"(<general joint="j" dyntype="integrator"/>)", R"(<motor joint="j"/><position joint="j" kp="3"/>)",
          R"(<motor joint="j"/><motor joint="j"/>)"}) {
        INFO(on_j);
        CHECK(reported(on_j, "j") == 1);
        CHECK(reported(on_j, "k") == 0);
    }
    CHECK(reported(R"(<position tendon="f" kp="3"/>)", "k") == 1);
    CHECK(reported(R"(<position tendon="f" kp="3"/>)", "j") == 0);
    for (const char* on_both : {R"(<motor site="t"/>)", R"(<motor tendon="w"/>)"}) {
        CHECK(reported(on_both, "j") == 1);
        CHECK(reported(on_both, "k") == 1);
    }
    CHECK(joined(driven(R"(<motor joint="j"/><motor joint="j" gear="2" ctrlrange="-1 1"/>)")) ==
          "motor: gear=\"2\" ctrlrange=\"-1 1\"\n");
}

TEST_CASE("import: tendons that pull are reported, and coordinates that they tie are refused")
{
    const std::string tip =
        "/><body><inertial mass=\"1\" pos=\".1 0 0\" diaginertia=\".1 .1 .1\"/><joint name=\"k\" "
        "axis=\"0 1 0\"/></body><geom mass=\"0\" size=\".01\"";
    const auto with = [&](const std::string& tendon, const std::string& joint) {
        return imported({.geom = tip,
                         .before = R"(<default><default class="stiff"><tendon stiffness="50"/></default></default>)",
                         .after = "<tendon>" + tendon + "</tendon>"},
                        joint);
    };
    const std::string joints = R"(<joint joint="k" coef="1"/></fixed>)";
    for (const char* pulling :
         {"stiffness=\"9\"", "damping=\"9\"", "frictionloss=\"1\"", "range=\"-1 1\"", "class=\"stiff\""})
        for (const char* joint : {"j", "k"}) {
            INFO(pulling);
            CHECK(with("<fixed name=\"f\" " + std::string(pulling) + ">" + joints, joint).not_taken.size() == 1);
        }
    for (const char* idle : {"", "range=\"-1 1\" limited=\"false\"", "springlength=\"0 1\""})
        CHECK(with("<fixed name=\"f\" " + std::string(idle) + ">" + joints, "k").not_taken.empty());
    CHECK(joined(with("<spatial name=\"w\" stiffness=\"4\"/>", "j")) == "spatial: stiffness=\"4\"\n");
    const auto tied =
        with("<fixed name=\"f\">" + joints + "</tendon><equality><tendon tendon1=\"f\"/></equality><tendon>", "k");
    CHECK(tied.loop != nullptr);
}
