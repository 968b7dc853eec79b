// Any bytes as URDF or MJCF: a robot whose joints can be imported, or a list of complaints. A joint that is written
// down with nothing left to fill in reads back.
#include "analysis/joint/parameters.h"
#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/import_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/robot_table.h"
#include "tests/fuzz/input_file.h"

namespace {

using namespace stickslip;

void import_some(const Robot& robot)
{
    const auto bodies = static_cast<int>(robot.bodies.size());
    for (int i = 0; i < bodies; ++i)
        fuzz::promise(robot.bodies[static_cast<std::size_t>(i)].parent < i, "a body before its parent");
    const auto pose = read_pose(robot, {});
    fuzz::promise(pose.size() == robot.joints.size(), "a pose of another robot");
    constexpr int few = 4;  // joints of an input
    for (int i = 0; i < std::min(few, static_cast<int>(robot.joints.size())); ++i) {
        const RobotJoint& joint = robot.joints[static_cast<std::size_t>(i)];
        fuzz::promise(joint.body >= 0 && joint.body < bodies, "a joint without a body");
        if (joint.kind == RobotJointKind::fixed) continue;
        const auto answer = import_joint(robot, i, pose);
        const auto text = import_text(answer, "robot", "");
        if (!answer.missing.empty() || answer.loop || !check(answer.joint).empty()) continue;
        read_joint_text(text, "imported.toml", "/nonexistent");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const fuzz::InputFile file({data, size});
        import_some(read_robot(file.path()));
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
