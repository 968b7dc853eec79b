// What the actuators of MJCF are to the joints: servos that hold them, one motor that drives them, or neither.
#include "sweep/files/robots/mjcf_actuator.h"
#include "sweep/files/robots/mjcf_forces.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {
namespace {

/// Attributes of an actuator as they are written, its own or of its class.
const std::vector<const char*> written{"kp",       "kv",     "dampratio", "dyntype",    "gaintype",
                                       "biastype", "dynprm", "gainprm",   "biasprm",    "timeconst",
                                       "delay",    "gear",   "ctrlrange", "forcerange", "actrange"};

/// Which joints the actuator acts on.
void set_target(const MjcfNames& names, const pugi::xml_node& node, NotTaken& element)
{
    const auto body = [&](const std::map<std::string, int>& of, const char* attribute) {
        const auto found = of.find(node.attribute(attribute).as_string());
        if (found != of.end()) element.bodies.push_back(found->second);
    };
    body(names.bodies, "body");
    for (const char* attribute : {"site", "cranksite", "slidersite"}) body(names.sites, attribute);
    if (const auto tendon = names.tendons.find(node.attribute("tendon").as_string()); tendon != names.tendons.end()) {
        element.joints = tendon->second.joints;
        element.every_joint = tendon->second.spatial;
    }
}

class Drives {
  public:
    Drives(const MjcfInput& input, Robot& robot) : input_(input), robot_(robot) {}

    void take(const pugi::xml_node& node, int joint, const MjcfActuator& a)
    {
        auto& j = robot_.joints[static_cast<std::size_t>(joint)];
        const double square = a.gear * a.gear;
        j.damping += square * a.damping;
        j.armature += square * a.armature;
        if (input_.file.numbers(node, "damping").size() > 1)
            leave_out(node, joint, NotTakenReason::nonlinear, {"damping"});
        if (a.known && a.is_position_servo())
            add_servo(node, joint, a, square * a.gain, -square * std::min(a.bias[2], 0.0), true);
        else if (a.known && a.is_velocity_servo())
            add_servo(node, joint, a, 0, square * a.gain, false);
        else if (a.known && a.is_motor())
            motors_.push_back({node, joint, a});
        else
            leave_out(node, joint, NotTakenReason::actuator, written);
    }

    /// A joint of ours has one command: that of its servos, otherwise of its first motor.
    void finish()
    {
        for (const auto& [node, joint, a] : motors_) {
            auto& j = robot_.joints[static_cast<std::size_t>(joint)];
            if (servos_.count(joint) || is_set(j.motor.effort_per_command)) {
                leave_out(node, joint, NotTakenReason::actuator, written);
                continue;
            }
            j.gear = a.gear;
            j.motor.effort_per_command = a.gear * a.gain;
            if (input_.acts("clampctrl")) limit(node, joint, a.command, "ctrlrange", 1, j.motor.command_limit);
            limit(node, joint, a.force, "forcerange", std::abs(a.gear), j.motor.effort_limit);
            if (a.filters()) {
                j.motor.lag = std::max(0.0, a.time);
                limit(node, joint, a.activation, "actrange", std::abs(j.motor.effort_per_command),
                      j.motor.effort_limit);
            }
            j.motor.delay = std::max(0.0, a.delay);
        }
        for (const auto& [joint, servos] : servos_) {
            auto& j = robot_.joints[static_cast<std::size_t>(joint)];
            for (const auto& [node, a] : servos) {
                if (servos.size() == 1)
                    limit(node, joint, a.force, "forcerange", std::abs(a.gear), j.servo.effort_limit);
                // each of several clamps its own part, which a limit of their sum does not express
                else if (std::isfinite(a.force.greatest))
                    leave_out(node, joint, NotTakenReason::limit, {"forcerange"});
            }
        }
    }

  private:
    /// Of two limits the tighter; ours are the same in both directions.
    void limit(const pugi::xml_node& node, int joint, const MjcfRange& range, const char* name, double factor,
               double& ours)
    {
        ours = std::min(ours, factor * range.greatest);
        if (range.lopsided) leave_out(node, joint, NotTakenReason::lopsided, {name});
    }

    void add_servo(const pugi::xml_node& node, int joint, const MjcfActuator& a, double k_p, double k_v, bool own)
    {
        auto& j = robot_.joints[static_cast<std::size_t>(joint)];
        auto& s = j.servo;
        const auto sum = [](double before, double more) { return (is_set(before) ? before : 0) + more; };
        j.gear = a.gear;
        if (k_p != 0) s.k_p = sum(s.k_p, k_p);
        s.k_v = sum(s.k_v, k_v);
        if (own) s.own_k_v += k_v;
        if (own && a.bias[2] > 0) s.per_root_inertia += 2 * a.bias[2] * std::sqrt(std::max(k_p, 0.0));
        servos_[joint].push_back({node, a});
        if (a.filters() || a.delay > 0)
            leave_out(node, joint, NotTakenReason::target, {"timeconst", "dyntype", "dynprm", "actrange", "delay"});
    }

    void leave_out(const pugi::xml_node& node, int joint, NotTakenReason reason,
                   const std::vector<const char*>& attributes)
    {
        pugi::xml_node with_class = node;
        input_.apply_defaults(with_class, "");
        auto element = not_taken(input_, reason, with_class, attributes);
        element.joints = {joint};
        robot_.not_taken.push_back(element);
    }

    struct Motor {
        pugi::xml_node node;
        int joint;
        MjcfActuator actuator;
    };

    const MjcfInput& input_;
    Robot& robot_;
    std::vector<Motor> motors_;
    std::map<int, std::vector<std::pair<pugi::xml_node, MjcfActuator>>> servos_;  ///< by joint
};

}  // namespace

void read_actuators(const MjcfInput& input, const MjcfNames& names, Robot& robot)
{
    if (!input.acts("actuation")) return;
    Drives drives(input, robot);
    for (const auto& list : input.file.root().children("actuator"))
        for (const auto& node : list.children()) {
            std::string joint = node.attribute("joint").as_string();
            if (joint.empty()) joint = node.attribute("jointinparent").as_string();
            const auto a = read_actuator(input, node);
            if (const int index = index_of_joint(robot, joint); index >= 0) {
                drives.take(node, index, a);
                continue;
            }
            auto attributes = written;
            attributes.insert(attributes.begin(), {"tendon", "site", "body", "cranksite", "slidersite"});
            auto element = not_taken(input, NotTakenReason::actuator, node, attributes);
            set_target(names, node, element);
            robot.not_taken.push_back(element);
        }
    drives.finish();
}

}  // namespace stickslip::files
