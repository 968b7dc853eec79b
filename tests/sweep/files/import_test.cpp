// One joint of a robot against closed forms of planar arms, from both formats.
#include <catch2/catch.hpp>

#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/import_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/robot_table.h"
#include "tests/temporary_directory.h"

#include <cmath>
#include <fstream>

using namespace stickslip;

namespace {

std::filesystem::path written(const TemporaryDirectory& room, const std::string& name, const std::string& text)
{
    const auto file = room.path() / name;
    std::ofstream(file) << text;
    return file;
}

// Two links in the vertical plane, turning about −y, hanging down at zero: masses 2 and 1 kg at 0.3 and 0.2 m, link 1
// is 0.5 m long, inertias 0.04 and 0.01 kg m² about their centres.
constexpr double m1 = 2, m2 = 1, c1 = 0.3, c2 = 0.2, l1 = 0.5, I1 = 0.04, I2 = 0.01, g = 9.81;

const char* const arm_urdf = R"(<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0 -0.3"/><mass value="2"/>
    <inertia ixx="0.04" ixy="0" ixz="0" iyy="0.04" iyz="0" izz="0.04"/></inertial></link>
  <link name="lower"/>
  <link name="tip"><inertial><origin xyz="0 0 0"/><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 -1 0"/>
    <limit lower="-2" upper="2" effort="30" velocity="3"/><dynamics damping="0.7" friction="0.4"/></joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="lower"/><origin xyz="0 0 -0.5"/><axis xyz="0 -1 0"/></joint>
  <joint name="mount" type="fixed"><parent link="lower"/><child link="tip"/><origin xyz="0 0 -0.2" rpy="0.3 0.2 0.1"/></joint>
</robot>
)";

const char* const arm_mjcf = R"(<mujoco>
  <compiler angle="degree"/>
  <default><joint axis="0 -1 0"/><default class="heavy"><joint armature="0.5" damping="0.7" frictionloss="0.4"/></default></default>
  <worldbody><body name="upper">
    <inertial pos="0 0 -0.3" mass="2" diaginertia="0.04 0.04 0.04"/>
    <joint name="shoulder" class="heavy" range="-90 90"/>
    <body name="lower" pos="0 0 -0.5">
      <inertial pos="0 0 -0.2" mass="1" fullinertia="0.01 0.01 0.01 0 0 0"/>
      <joint name="elbow" ref="30"/>
    </body>
  </body></worldbody>
  <actuator><position joint="elbow" kp="80" kv="2" forcerange="-5 5"/></actuator>
</mujoco>
)";

void check_shoulder(const AxisDynamics& d, double elbow, double shoulder)
{
    const double inertia = I1 + m1 * c1 * c1 + I2 + m2 * (l1 * l1 + c2 * c2 + 2 * l1 * c2 * std::cos(elbow));
    CHECK(d.inertia == Approx(inertia).epsilon(1e-12));
    const auto effort = [&](double q) {
        return -(m1 * c1 + m2 * l1) * g * std::sin(q) - m2 * c2 * g * std::sin(q + elbow);
    };
    CHECK(d.gravity_effort == Approx(effort(shoulder)).epsilon(1e-12));
    for (const double q : {-1.0, 0.0, 0.4, 2.5})
        CHECK(-d.gravity_amplitude * std::sin(q + d.gravity_phase) == Approx(effort(q)).epsilon(1e-12).margin(1e-12));
    const double h = 1e-5;
    CHECK(d.gravity_stiffness == Approx(-(effort(shoulder + h) - effort(shoulder - h)) / (2 * h)).epsilon(1e-8));
}

std::string complaint(const TemporaryDirectory& room, const std::string& name, const std::string& text)
{
    try {
        read_robot(written(room, name, text));
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("import: a two-link arm from URDF has the inertia and gravity of its closed form")
{
    const TemporaryDirectory room;
    const Robot robot = read_robot(written(room, "arm.urdf", arm_urdf));
    const int shoulder = joint_named(robot, "shoulder", "arm.urdf"), elbow = joint_named(robot, "elbow", "arm.urdf");
    for (const double bent : {0.0, 0.9, -2.0})
        for (const double at : {0.0, 0.7}) {
            std::vector<double> pose(2);
            pose[static_cast<std::size_t>(shoulder)] = at;
            pose[static_cast<std::size_t>(elbow)] = bent;
            check_shoulder(axis_dynamics(robot, shoulder, pose), bent, at);
            CHECK(axis_dynamics(robot, elbow, pose).inertia == Approx(I2 + m2 * c2 * c2));
        }
    const auto answer = import_joint(robot, shoulder, {0.0, 0.0});
    CHECK(answer.joint.control.effort_limit == 30);
    CHECK(std::get<CoulombViscous>(answer.joint.friction.law).coulomb == 0.4);
    CHECK(answer.missing == std::vector<std::string>{"control.k_p"});
    CHECK(import_text(answer, "arm.urdf", "").find("# k_p =") != std::string::npos);
}

TEST_CASE("import: the same arm from MJCF, with defaults, degrees and a servo")
{
    const TemporaryDirectory room;
    const Robot robot = read_robot(written(room, "arm.xml", arm_mjcf));
    const int shoulder = joint_named(robot, "shoulder", "arm.xml"), elbow = joint_named(robot, "elbow", "arm.xml");
    const double ref = std::acos(-1.0) / 6;
    const auto pose = read_pose(robot, written(room, "pose.toml", "shoulder = \"40 deg\"\n"));
    CHECK(pose[static_cast<std::size_t>(elbow)] == Approx(ref));
    check_shoulder(axis_dynamics(robot, shoulder, pose), 0, 40 * std::acos(-1.0) / 180);
    const auto upper = import_joint(robot, shoulder, pose);
    CHECK(upper.joint.mechanism.inertia == Approx(upper.dynamics.inertia + 0.5));
    CHECK(upper.described.high == Approx(std::acos(-1.0) / 2));
    const auto lower = import_joint(robot, elbow, pose);
    CHECK(lower.joint.control.k_p == 80);
    CHECK(lower.joint.control.k_v == 2);
    CHECK(lower.joint.control.effort_limit == 5);
    CHECK(lower.missing.empty());
    const Joint read = read_joint_text(import_text(lower, "arm.xml", ""), "imported");
    CHECK(read.mechanism.inertia == Approx(0.05));
}

TEST_CASE("import: solids of even density have the inertia of their closed form")
{
    const TemporaryDirectory room;
    const auto inertia = [&](const std::string& geom) {
        const Robot robot = read_robot(written(room, "solid.xml",
                                               "<mujoco><worldbody><body><joint name=\"j\" axis=\"0 0 1\"/><geom " +
                                                   geom + "/></body></worldbody></mujoco>"));
        return axis_dynamics(robot, 0, {0}).inertia;
    };
    CHECK(inertia("type=\"sphere\" size=\"0.1\" mass=\"2\" pos=\"1 0 0\"") == Approx(0.4 * 2 * 0.01 + 2));
    CHECK(inertia("type=\"box\" size=\"0.1 0.2 0.3\" mass=\"3\"") == Approx(3 * (0.04 + 0.16) / 12));
    CHECK(inertia("type=\"cylinder\" size=\"0.1 0.3\" mass=\"3\"") == Approx(3 * 0.01 / 2));
    // a rod across the axis, fromto: m l²/12 + m r²/4
    CHECK(inertia("type=\"cylinder\" size=\"0.1\" fromto=\"-0.3 0 0 0.3 0 0\" mass=\"3\"") ==
          Approx(3 * (0.36 / 12 + 0.01 / 4)));
    // density of water by default; a capsule without length is a ball
    CHECK(inertia("type=\"sphere\" size=\"0.1\"") == Approx(0.4 * 0.01 * 1000 * 4. / 3 * std::acos(-1.0) * 1e-3));
    CHECK(inertia("type=\"capsule\" size=\"0.1 1e-9\" mass=\"2\"") == Approx(0.4 * 2 * 0.01));
}

TEST_CASE("import: an inertia that no rigid body has is counted and said")
{
    const TemporaryDirectory room;
    const auto imported = [&](const std::string& moments) {
        const std::string text =
            replaced(arm_urdf, "</robot>",
                     "<link name=\"tool\"><inertial><mass value=\"1\"/><inertia " + moments +
                         "/></inertial></link><joint name=\"on\" type=\"fixed\"><parent link=\"tip\"/><child "
                         "link=\"tool\"/></joint></robot>");
        const Robot robot = read_robot(written(room, "tool.urdf", text));
        const int elbow = joint_named(robot, "elbow", "tool.urdf");
        return import_joint(robot, elbow, std::vector<double>(robot.joints.size(), 0.0));
    };
    const auto wrong = imported("ixx=\"0.1\" iyy=\"0.1\" izz=\"0.3\"");
    REQUIRE(wrong.impossible.size() == 1);
    CHECK(wrong.impossible[0].body == "link \"tool\"");
    CHECK(wrong.impossible[0].moments[2] == Approx(0.3));
    const auto right = imported("ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\"");
    CHECK(right.impossible.empty());
    CHECK(import_text(wrong, "tool.urdf", "").find("no rigid body has") != std::string::npos);
    CHECK(import_text(right, "tool.urdf", "").find("no rigid body has") == std::string::npos);
    // a thin plate whose moments have two digits: 0.052 + 0.052 = 0.104, written 0.05, 0.05 and 0.1
    CHECK(imported("ixx=\"0.052\" iyy=\"0.052\" izz=\"0.1045\"").impossible.empty());
}

TEST_CASE("import: a description in millimetres and degrees is counted as written and said")
{
    const TemporaryDirectory room;
    const auto imported = [&](const std::string& text) {
        const Robot robot = read_robot(written(room, "arm.urdf", text));
        const int elbow = joint_named(robot, "elbow", "arm.urdf");
        return import_joint(robot, elbow, std::vector<double>(robot.joints.size(), 0.0));
    };
    CHECK(imported(arm_urdf).suspected.empty());
    const std::string tool =
        "<link name=\"tool\"><inertial><mass value=\"2\"/><inertia ixx=\"3200\" iyy=\"3200\" "
        "izz=\"3200\"/></inertial></link><joint name=\"on\" type=\"fixed\"><parent link=\"tip\"/><child "
        "link=\"tool\"/></joint></robot>";  // kg·mm²: a radius of gyration of 49 mm
    const auto millimetres = imported(replaced(arm_urdf, "</robot>", tool));
    REQUIRE(millimetres.suspected.size() == 1);
    CHECK(millimetres.suspected[0].of == "link \"tool\"");
    CHECK(millimetres.suspected[0].kind == SuspectedUnit::Kind::length);
    CHECK(millimetres.suspected[0].value == Approx(std::sqrt(1.5 * 3200 / 2)));
    CHECK(import_text(millimetres, "arm.urdf", "").find("lengths are in metres") != std::string::npos);
    Robot robot = read_robot(written(room, "arm.urdf", arm_urdf));
    const int elbow = joint_named(robot, "elbow", "arm.urdf");
    auto& limits = robot.joints[static_cast<std::size_t>(elbow)];
    limits.low = -90, limits.high = 90;
    const auto degrees = suspected_units(robot, elbow);
    REQUIRE(degrees.size() == 1);
    CHECK(degrees[0].kind == SuspectedUnit::Kind::angle);
    CHECK(degrees[0].value == Approx(180));
    limits.high = limits.low + 50;
    CHECK(suspected_units(robot, elbow).empty());
}

TEST_CASE("import: limits near the ends of travel and springs of Gazebo are reported, for the joint that has them")
{
    const TemporaryDirectory room;
    const std::string safe = replaced(arm_urdf, "<dynamics", "<safety_controller k_velocity=\"9\"/><dynamics");
    const std::string spring =
        "<gazebo reference=\"elbow\"><springReference>0.5</springReference><springStiffness>30</springStiffness>"
        "</gazebo></robot>";
    const Robot robot = read_robot(written(room, "arm.urdf", replaced(safe, "</robot>", spring)));
    const auto of = [&](const char* name) {
        return import_joint(robot, joint_named(robot, name, "arm.urdf"), {0.0, 0.0}).not_taken;
    };
    REQUIRE(of("shoulder").size() == 1);
    CHECK(of("shoulder")[0].reason == NotTakenReason::safety);
    CHECK(of("shoulder")[0].attributes == "k_velocity=\"9\"");
    REQUIRE(of("elbow").size() == 1);
    CHECK(of("elbow")[0].attributes == "springStiffness=\"30\" springReference=\"0.5\"");
    CHECK_THAT(of("elbow")[0].place, Catch::EndsWith("arm.urdf:13"));
}

TEST_CASE("import: a pose beyond a joint's limits is said, with the limits")
{
    const TemporaryDirectory room;
    const Robot robot = read_robot(written(room, "arm.urdf", arm_urdf));
    const int elbow = joint_named(robot, "elbow", "arm.urdf");
    const auto at = [&](const std::string& shoulder) {
        return import_joint(robot, elbow, read_pose(robot, written(room, "at.toml", "shoulder = " + shoulder + "\n")));
    };
    const auto beyond = at("2.5");
    REQUIRE(beyond.beyond.size() == 1);
    CHECK_THAT(import_text(beyond, "arm.urdf", "at.toml"),
               Catch::Contains("joint \"shoulder\" is at 2.5 rad, outside its limits -2 to 2 rad (") &&
                   Catch::Contains("arm.urdf:9)"));
    for (const char* within : {"2", "-1", "2.00005"}) CHECK(at(within).beyond.empty());
    CHECK(at("-2.1").beyond.size() == 1);
}

TEST_CASE("import: a joint that gravity does not turn has neither effort nor stiffness, and no minus before its zero")
{
    const TemporaryDirectory room;
    const Robot robot = read_robot(
        written(room, "upright.urdf",
                replaced(arm_urdf, "<axis xyz=\"0 -1 0\"/>\n    <limit", "<axis xyz=\"0 0 1\"/>\n    <limit")));
    const int shoulder = joint_named(robot, "shoulder", "upright.urdf");
    for (const double turned : {0.0, 0.3, -1.0}) {
        const auto answer = import_joint(robot, shoulder, {turned, 0.4});
        const auto text = import_text(answer, "upright.urdf", "");
        INFO(text);
        CHECK_THAT(text, Catch::Contains("gravity is 0 N·m, its stiffness 0 N·m/rad"));
        CHECK(answer.dynamics.gravity_amplitude == 0);
    }
}

TEST_CASE("import: what cannot be used is refused by file and line")
{
    const TemporaryDirectory room;
    const Robot robot = read_robot(written(room, "arm.urdf", arm_urdf));
    CHECK_THROWS_WITH(joint_named(robot, "elbwo", "arm.urdf"),
                      Catch::Contains("shoulder, elbow") && Catch::Contains("did you mean"));
    CHECK_THROWS_WITH(read_pose(robot, written(room, "pose.toml", "elbwo = 1\n")), Catch::Contains("pose.toml:1"));
    CHECK_THROWS_WITH(read_pose(robot, written(room, "mm.toml", "elbow = \"3 mm\"\n")), Catch::Contains("rad"));

    const std::string loop = replaced(arm_urdf, "<child link=\"tip\"/>", "<child link=\"upper\"/>");
    CHECK_THAT(complaint(room, "loop.urdf", loop), Catch::Contains("loop") && Catch::Contains("loop.urdf:12"));
    const std::string light =
        replaced(replaced(arm_urdf, "<mass value=\"1\"/>", "<mass value=\"0\"/>"), "ixx=\"0.01\"", "ixx=\"0\"");
    CHECK_THAT(complaint(room, "light.urdf", light), Catch::Contains("elbow") && Catch::Contains("no inertia"));
    CHECK_THAT(complaint(room, "number.urdf", replaced(arm_urdf, "0 0 -0.5", "0 0 x")),
               Catch::Contains("number.urdf:11"));
    CHECK_THAT(complaint(room, "xacro.urdf", replaced(arm_urdf, "0 0 -0.5", "0 0 ${l}")), Catch::Contains("xacro"));
    CHECK_THAT(complaint(room, "include.urdf",
                         replaced(arm_urdf, "<link name=\"base\"/>", "<xacro:include filename=\"base.xacro\"/>")),
               Catch::Contains("include.urdf:3") && Catch::Contains("run xacro"));
    CHECK_THAT(complaint(room, "half.urdf", replaced(arm_urdf, "<mass value=\"2\"/>", "")),
               Catch::Contains("half.urdf:4") && Catch::Contains("of link \"upper\" needs <mass>"));
    CHECK_THAT(complaint(room, "cut.urdf", std::string(arm_urdf).substr(0, 400)), Catch::Contains("is not XML"));
    CHECK_THAT(complaint(room, "free.xml", replaced(arm_mjcf, "<joint name=\"elbow\" ref=\"30\"/>", "<freejoint/>")),
               Catch::Contains("free.xml:9") && Catch::Contains("expected it in a body of <worldbody> only"));
    CHECK_THAT(complaint(room, "other.xml", "<sdf/>"), Catch::Contains("<sdf>"));
    CHECK_THAT(
        complaint(room, "mesh.xml", "<mujoco><worldbody><body><joint/><geom mesh=\"m\"/></body></worldbody></mujoco>"),
        Catch::Contains("mesh"));

    const std::string tied = replaced(arm_mjcf, "</worldbody>",
                                      "</worldbody><equality><connect body1=\"lower\" anchor=\"0 0 0\"/></equality>");
    const Robot closed = read_robot(written(room, "tied.xml", tied));
    CHECK(import_joint(closed, 0, {0, 0}).loop != nullptr);
}

TEST_CASE("import: a joint whose coordinate is tied to another's is refused, one that carries both is not")
{
    const TemporaryDirectory room;
    const std::string follower =
        R"(<link name="finger"><inertial><mass value="0.1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4"/></inertial></link>
  <joint name="follower" type="revolute"><parent link="lower"/><child link="finger"/><axis xyz="0 1 0"/><limit effort="1" velocity="1"/>
    <mimic joint="elbow" multiplier="-1"/></joint>
</robot>)";
    const std::string urdf = replaced(arm_urdf, "</robot>", follower);
    const std::string mjcf = replaced(arm_mjcf, "</worldbody>",
                                      "</worldbody><equality><joint joint1=\"elbow\" joint2=\"follower\"/></equality>");
    const std::string finger =
        R"(<body name="finger"><inertial pos="0 0 0" mass="0.1" diaginertia="1e-4 1e-4 1e-4"/><joint name="follower"/></body>
    </body>
  </body></worldbody>)";
    const auto end = mjcf.find("    </body>\n  </body></worldbody>");
    const std::string both =
        std::string(mjcf).replace(end, std::string("    </body>\n  </body></worldbody>").size(), finger);
    for (const auto& [name, text] : {std::pair{"mimic.urdf", urdf}, std::pair{"tied.xml", both}}) {
        const Robot robot = read_robot(written(room, name, text));
        const std::vector<double> pose(robot.joints.size(), 0);
        INFO(name);
        REQUIRE(robot.joints.size() == 3);
        CHECK(import_joint(robot, joint_named(robot, "shoulder", name), pose).loop == nullptr);
        for (const char* joint : {"elbow", "follower"}) {
            const auto* loop = import_joint(robot, joint_named(robot, joint, name), pose).loop;
            REQUIRE(loop != nullptr);
            CHECK_THAT(loop->place, Catch::StartsWith((room.path() / name).string() + ":"));
        }
    }
    CHECK_THAT(complaint(room, "lost.urdf", replaced(urdf, "mimic joint=\"elbow\"", "mimic joint=\"elbwo\"")),
               Catch::Contains("lost.urdf:15") && Catch::Contains("\"elbwo\""));
}
