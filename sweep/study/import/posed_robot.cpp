#include "sweep/study/import/posed_robot.h"

namespace stickslip {
namespace {

class PosedRobot : public PosedDynamics {
  public:
    PosedRobot(Robot robot, int index, double armature, const std::string& identity)
        : PosedDynamics(around(robot, index), identity), robot_(std::move(robot)), index_(index), armature_(armature)
    {
        for (const auto& joint : robot_.joints) drawn_.push_back(joint.reference);
        for (std::size_t i = 0; i < robot_.joints.size(); ++i)
            if (is_other(robot_, i, index)) place_.push_back(i);
    }

    std::vector<double> reference() const
    {
        std::vector<double> pose;
        for (const std::size_t i : place_) pose.push_back(drawn_[i]);
        return pose;
    }

    void apply(const std::vector<double>& pose, Joint& joint) const override
    {
        auto whole = drawn_;
        for (std::size_t i = 0; i < pose.size(); ++i) whole[place_[i]] = pose[i];
        const auto& described = robot_.joints[static_cast<std::size_t>(index_)];
        take_dynamics(axis_dynamics(robot_, index_, whole), described.armature + armature_, joint);
    }

  private:
    static bool is_other(const Robot& robot, std::size_t i, int index)
    {
        return static_cast<int>(i) != index && robot.joints[i].kind != RobotJointKind::fixed;
    }
    static std::vector<RobotNeighbour> around(const Robot& robot, int index)
    {
        std::vector<RobotNeighbour> found;
        for (std::size_t i = 0; i < robot.joints.size(); ++i) {
            const auto& joint = robot.joints[i];
            const bool turns = joint.kind == RobotJointKind::hinge;
            if (is_other(robot, i, index))
                found.push_back({joint.name, turns ? Quantity::angle : Quantity::length, joint.low, joint.high});
        }
        return found;
    }

    Robot robot_;
    int index_;
    double armature_;
    std::vector<double> drawn_;       ///< one coordinate a joint of the robot
    std::vector<std::size_t> place_;  ///< of each coordinate of a pose among them
};

}  // namespace

void take_dynamics(const AxisDynamics& axis, double armature, Joint& joint)
{
    const bool single = joint.mechanism.model == Model::single_mass;
    (single ? joint.mechanism.inertia : joint.mechanism.link_inertia) = axis.inertia + (single ? armature : 0);
    joint.load.gravity_amplitude = axis.gravity_amplitude;
    joint.load.gravity_phase = axis.gravity_phase;
    if (joint.mechanism.motion == Motion::prismatic) joint.load.constant = axis.gravity_effort;
}

void place_in_robot(Joint& joint, Robot robot, int index, double armature, const std::string& identity)
{
    const auto posed = std::make_shared<PosedRobot>(std::move(robot), index, armature, identity);
    joint.pose = {posed, posed->reference()};
    posed->apply(joint.pose.coordinates, joint);
}

}  // namespace stickslip
