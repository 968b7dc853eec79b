// One joint of a robot as a joint of ours.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/study/import/robot.h"

#include <string>
#include <vector>

namespace stickslip {

/// A joint and where it stands.
struct PoseBeyondLimits {
    RobotJoint joint;
    double position = 0;
};

struct ImportAnswer {
    Joint joint;  ///< one mass; gains only where the robot's description has them
    AxisDynamics dynamics;
    RobotJoint described;
    double position = 0;                        ///< of the joint at this pose
    std::vector<std::string> missing;           ///< paths of required numbers that no robot description has
    std::vector<ImpossibleInertia> impossible;  ///< counted as they are described
    std::vector<SuspectedUnit> suspected;       ///< counted as they are described
    std::vector<PoseBeyondLimits> beyond;       ///< joints that cannot reach this pose
    std::vector<NotTaken> not_taken;            ///< elements that act on the joint and are not in `joint`
    const RobotClosure* loop =
        nullptr;  ///< what ties the joint to the rest, into the robot: nothing else is then valid
};

ImportAnswer import_joint(const Robot& robot, int joint, const std::vector<double>& pose);

}  // namespace stickslip
