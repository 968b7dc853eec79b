// A joint in its robot: numbers at every pose, what a spec refuses, and the spec that needs no other file.
#include <catch2/catch.hpp>

#include "analysis/joint/parameters.h"
#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/robot_table.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/study/import/import.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <cmath>
#include <fstream>

using namespace stickslip;
using Catch::Contains;

namespace {

const char* const arm = R"(<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0 -0.3"/><mass value="2"/>
    <inertia ixx="0.04" ixy="0" ixz="0" iyy="0.04" iyz="0" izz="0.04"/></inertial></link>
  <link name="lower"><inertial><origin xyz="0 0 -0.2"/><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="hand"><inertial><mass value="0.5"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 -1 0"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="0 0 -0.5"/><axis xyz="0 -1 0"/>
    <limit lower="-2" upper="2" effort="30" velocity="3"/></joint>
  <joint name="reach" type="prismatic"><parent link="lower"/><child link="hand"/><origin xyz="0 0 -0.3"/><axis xyz="0 0 -1"/>
    <limit lower="0" upper="0.4" effort="30" velocity="3"/></joint>
</robot>
)";

const char* const joint = R"([joint]
motion = "revolute"
inertia = 1.0
[control]
k_p = 200
V0 = 0.01
[friction]
law = "coulomb-viscous"
coulomb = 1.0
viscous = 0.1
)";

const char* const in_arm = "[robot]\nfile = \"arm.urdf\"\njoint = \"shoulder\"\n";

struct Room {
    TemporaryDirectory folder;

    Room()
    {
        write("arm.urdf", arm);
        write("shoulder.toml", joint);
    }
    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder.path() / name) << text;
        return folder.path() / name;
    }
    /// A spec of the joint file and these tables.
    std::filesystem::path spec(const std::string& tables) const
    {
        return write("spec.toml", "joint = \"shoulder.toml\"\n" + tables);
    }
    /// The only message about such a spec, behind the name of the file.
    std::string only_error(const std::string& tables) const
    {
        const auto file = spec(tables);
        const auto all = messages_of([&] { read_spec(file); });
        REQUIRE(all.size() == 1);
        return all[0].substr(all[0].find(file.string()) == 0 ? file.string().size() + 1 : 0);
    }
};

/// The joint that `stickslip import --at` makes there.
Joint imported(const Room& room, const std::string& pose)
{
    const auto robot = read_robot(room.folder.path() / "arm.urdf");
    return import_joint(robot, joint_named(robot, "shoulder", "arm"), read_pose(robot, room.write("pose.toml", pose)))
        .joint;
}

void check_like(const Joint& posed, const Joint& wanted, double armature)
{
    CHECK(posed.mechanism.inertia == wanted.mechanism.inertia + armature);
    CHECK(posed.load.gravity_amplitude == wanted.load.gravity_amplitude);
    CHECK(posed.load.gravity_phase == wanted.load.gravity_phase);
}

}  // namespace

TEST_CASE("a joint in a robot has the inertia and gravity that import gives it at each pose")
{
    const Room room;
    const auto spec =
        read_spec(room.spec(std::string(in_arm) +
                            "armature = 0.2\n[axes]\n\"pose.elbow\" = { from = 0, to = \"90 deg\", points = 4 }\n"
                            "[design]\n\"pose.reach\" = \"100 mm\"\n\"pose.elbow\" = 1\n"));
    REQUIRE(spec.axes.size() == 1);
    CHECK(spec.axes[0].values.back() == Approx(std::acos(0.0)));
    CHECK(unit_of(spec.axes[0].quantity, units_of(spec.joint)) == "rad");
    CHECK(spec.axes[0].symbol == "q_{elbow}");
    Joint there = spec.joint;
    for (const auto& [elbow, pose] : {std::pair{0.0, "reach = 0.1\n"}, {1.3, "reach = 0.1\nelbow = 1.3\n"}}) {
        number_at(there, "pose.elbow") = elbow;
        check_like(there, imported(room, pose), 0.2);
    }
    check_like(design_joint(spec), imported(room, "reach = 0.1\nelbow = 1\n"), 0.2);
    apply_setting(there, "pose.elbow=20 deg");
    check_like(there, imported(room, "reach = 0.1\nelbow = \"20 deg\"\n"), 0.2);
    // the number of a joint file is not touched by what the pose does not move
    CHECK(there.control.k_p == 200);
    CHECK_THAT(canonical_text(spec.joint), Contains("pose.of = robot "));
    CHECK_THAT(joint_text(spec.joint), !Contains("pose"));
}

TEST_CASE("of several masses the link has the inertia of the pose")
{
    const Room room;
    std::string text = joint;
    text.replace(text.find("inertia = 1.0"), 13,
                 "model = \"two-mass\"\nmotor_inertia = 0.1\nlink_inertia = 1\ntransmission = { stiffness = 900 }");
    text = text.substr(0, text.find("[friction]")) +
           "[friction.motor]\nlaw = \"coulomb-viscous\"\ncoulomb = 1.0\nviscous = 0.1\n"
           "[friction.link]\nlaw = \"coulomb-viscous\"\ncoulomb = 1.0\nviscous = 0.1\n";
    room.write("shoulder.toml", text);
    const auto spec = read_spec(room.spec(std::string(in_arm) + "[axes]\n\"pose.elbow\" = [0, 1]\n"));
    Joint there = spec.joint;
    number_at(there, "pose.elbow") = 1.0;
    CHECK(there.mechanism.link_inertia == imported(room, "elbow = 1\n").mechanism.inertia);
    CHECK(there.mechanism.motor_inertia == 0.1);
}

TEST_CASE("what a spec cannot have of its robot")
{
    const Room room;
    const std::string axes = "[axes]\n\"pose.elbow\" = [0, 1]\n", robot = in_arm;
    CHECK(
        room.only_error(robot + "[axes]\n\"pose.elbwo\" = [0, 1]\n") ==
        "6:1: axes.pose.elbwo: is none of the other joints of the robot, expected pose.elbow, pose.reach; did you mean "
        "\"pose.elbow\"?");
    CHECK_THAT(room.only_error(robot + "[axes]\n\"pose.shoulder\" = [0, 1]\n"),
               Contains("6:1: axes.pose.shoulder: is none of the other joints of the robot"));
    CHECK_THAT(room.only_error(axes),
               Contains("3:1: axes.pose.elbow: is a pose, which needs a [robot] table with file and joint"));
    CHECK_THAT(room.only_error(robot + "[axes]\n\"joint.inertia\" = [1, 2]\n"),
               Contains("6:1: axes.joint.inertia: follows from the pose of [robot]"));
    CHECK_THAT(room.only_error(robot + axes + "[design]\n\"load.gravity_phase\" = 1\n"),
               Contains("design.load.gravity_phase"));
    CHECK_THAT(room.only_error(robot + "[axes]\n\"pose.reach\" = [\"2 rad\"]\n"),
               Contains("pose.reach") && Contains(" m"));
    CHECK_THAT(room.only_error("[robot]\nfile = \"arm.urdf\"\njoint = \"sholder\"\n" + axes),
               Contains("there is no joint \"sholder\"") && Contains("did you mean \"shoulder\""));
    CHECK_THAT(room.only_error("[robot]\nfile = \"arm.urdf\"\njoint = \"reach\"\n" + axes),
               Contains("4:9: robot.joint: is \"reach\", which slides") && Contains("expected one that turns"));
    CHECK_THAT(room.only_error("[robot]\nfile = \"am.urdf\"\njoint = \"reach\"\n" + axes), Contains("am.urdf"));
    CHECK_THAT(room.only_error("[robot]\njoint = \"shoulder\"\n" + axes), Contains("2:1: robot.file: is missing"));
    CHECK_THAT(room.only_error("[robot]\nfile = \"arm.urdf\"\n" + axes), Contains("2:1: robot.joint: is missing"));
    CHECK_THAT(room.only_error(robot + "armature = \"1 kg\"\n" + axes), Contains("5:12: robot.armature"));
    CHECK_THAT(room.only_error(robot + "armatur = 1\n" + axes), Contains("did you mean \"armature\""));
}

TEST_CASE("a spec with a robot reads back without its files")
{
    for (const std::string table : {"[robot]\nfile = \"arm.urdf\"  # grün\njoint = \"shoulder\"\n",
                                    "[robot]\njoint = \"shoulder\"\n\"file\" = \"arm.urdf\"\n"}) {
        const Room room;
        const auto file = room.spec("title = \"Über die Pose\"\n" + table + "[axes]\n\"pose.elbow\" = [0, 1]\n");
        const auto there = read_spec_text(self_contained_text(file), "alone", "/nonexistent");
        CHECK(there.title == "Über die Pose");
        CHECK(canonical_text(there.joint) == canonical_text(read_spec(file).joint));
        Joint a = there.joint, b = read_spec(file).joint;
        number_at(a, "pose.elbow") = 1, number_at(b, "pose.elbow") = 1;
        CHECK(canonical_text(a) == canonical_text(b));
    }
}
