// MJCF: the tree of bodies, joints, actuators and equalities. https://mujoco.readthedocs.io/en/stable/XMLreference.html
#include "sweep/files/robots/mjcf_inertia.h"
#include "sweep/files/robots/robot_file.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stickslip::files {
namespace {

class MjcfReader {
  public:
    explicit MjcfReader(const std::filesystem::path& path) : input_(path) {}

    Robot read()
    {
        const auto root = input_.file.root();
        for (const auto& option : root.children("option"))
            robot_.gravity = input_.file.vector(option, "gravity", robot_.gravity);
        std::vector<SolidPart> of_the_world;
        for (const auto& world : root.children("worldbody"))
            contents(world, -1, "", Eigen::Isometry3d::Identity(), of_the_world);
        if (robot_.bodies.empty()) input_.file.fail(root, "has no <worldbody> with bodies");
        for (const auto& list : root.children("actuator"))
            for (const auto& actuator : list.children()) read_actuator(actuator);
        for (const auto& list : root.children("equality"))
            for (const auto& equality : list.children()) read_equality(equality);
        return std::move(robot_);
    }

  private:
    /// Bodies, joints and geoms under one element, all in `frame` of the body (<frame> elements nest).
    void contents(const pugi::xml_node& node, int body, const std::string& childclass, const Eigen::Isometry3d& frame,
                  std::vector<SolidPart>& geoms)
    {
        for (pugi::xml_node child : node.children()) {
            const std::string name = child.name();
            if (name == "body") {
                add_body(child, body, childclass, frame);
            } else if (name == "joint" || name == "freejoint") {
                if (body >= 0) add_joint(child, body, childclass, frame);
            } else if (name == "geom" && body >= 0) {
                input_.apply_defaults(child, childclass);
                if (!child.parent().child("inertial") || input_.inertia_from_geoms == "true")
                    geoms.push_back(placed(geom_part(input_, child), frame));
            } else if (name == "frame") {
                const std::string own = child.attribute("childclass").as_string(childclass.c_str());
                contents(child, body, own, frame * input_.frame(child), geoms);
            } else if (name == "replicate" || name == "attach" || name == "composite" || name == "flexcomp") {
                input_.file.fail(child, "is not supported: write its bodies out (mj_saveLastXML does)");
            }
        }
    }

    void add_body(const pugi::xml_node& node, int parent, const std::string& childclass, const Eigen::Isometry3d& frame)
    {
        const int index = static_cast<int>(robot_.bodies.size());
        RobotBody body;
        body.name = "body \"" + std::string(node.attribute("name").as_string()) + "\"";
        body.parent = parent;
        body.place = input_.file.place(node);
        body.frame = frame * input_.frame(node);
        body_of_[node.attribute("name").as_string()] = index;
        robot_.bodies.push_back(body);
        std::vector<SolidPart> parts;
        const auto inertial = node.child("inertial");
        const bool own = inertial && input_.inertia_from_geoms != "true";
        contents(node, index, node.attribute("childclass").as_string(childclass.c_str()), Eigen::Isometry3d::Identity(),
                 parts);
        if (own) parts = {inertial_part(input_, inertial)};
        set_inertia(robot_.bodies[static_cast<std::size_t>(index)], parts);
    }

    void add_joint(pugi::xml_node node, int body, const std::string& childclass, const Eigen::Isometry3d& frame)
    {
        input_.apply_defaults(node, childclass);
        const std::string type =
            std::string(node.name()) == "freejoint" ? "free" : node.attribute("type").as_string("hinge");
        if (type == "free" && robot_.bodies[static_cast<std::size_t>(body)].parent >= 0)
            input_.file.fail(node, "frees a body that another one carries; expected it in a body of <worldbody> only");
        if (type == "free" || type == "ball") return;  // stands where it is drawn
        RobotJoint joint;
        joint.name = node.attribute("name").as_string();
        joint.place = input_.file.place(node);
        joint.body = body;
        if (type != "hinge" && type != "slide")
            input_.file.fail(node, "is of type \"" + type + "\", expected hinge, slide, ball, free");
        joint.kind = type == "hinge" ? RobotJointKind::hinge : RobotJointKind::slide;
        joint.axis = frame.linear() * input_.file.vector(node, "axis", {0, 0, 1});
        if (joint.axis.norm() == 0) input_.file.fail(node, "axis has no direction");
        joint.axis.normalize();
        joint.anchor = frame * input_.file.vector(node, "pos", {0, 0, 0});
        const auto coordinate = [&](double v) { return joint.kind == RobotJointKind::hinge ? input_.angle(v) : v; };
        const auto first = [&](const char* name) {
            const auto values = input_.file.numbers(node, name);
            return values.empty() ? 0.0 : values[0];
        };
        joint.reference = coordinate(first("ref"));
        joint.damping = first("damping");
        joint.friction = first("frictionloss");
        joint.armature = first("armature");
        const std::string limited = node.attribute("limited").as_string("auto");
        if (const auto range = input_.file.numbers(node, "range");
            range.size() == 2 && (limited == "true" || (limited == "auto" && input_.autolimits))) {
            joint.low = coordinate(range[0]);
            joint.high = coordinate(range[1]);
        }
        if (const auto range = input_.file.numbers(node, "actuatorfrcrange"); range.size() == 2)
            joint.effort = std::max(std::abs(range[0]), std::abs(range[1]));
        robot_.bodies[static_cast<std::size_t>(body)].joints.push_back(static_cast<int>(robot_.joints.size()));
        robot_.joints.push_back(joint);
    }

    void read_actuator(pugi::xml_node node)
    {
        const std::string name = node.attribute("joint").as_string(), kind = node.name();
        for (auto& joint : robot_.joints) {
            if (name.empty() || joint.name != name) continue;
            input_.apply_defaults(node, "");
            const auto first = [&](const char* key, double standard) {
                const auto values = input_.file.numbers(node, key);
                return values.empty() ? standard : values[0];
            };
            joint.driven = true;
            joint.gear = first("gear", 1);
            const double gear = joint.gear * joint.gear;
            if (kind == "position") {
                joint.k_p = gear * first("kp", 1);
                if (!node.attribute("dampratio")) joint.k_v = gear * first("kv", 0);
            }
            if (kind == "velocity") joint.k_v = gear * first("kv", 1);
            const auto bias = input_.file.numbers(node, "biasprm"), gain = input_.file.numbers(node, "gainprm");
            if (kind == "general" && bias.size() > 1 && !gain.empty() && gain[0] == -bias[1]) {
                joint.k_p = gear * gain[0];
                joint.k_v = bias.size() > 2 ? -gear * bias[2] : 0;
            }
            if (const auto range = input_.file.numbers(node, "forcerange"); range.size() == 2)
                joint.effort =
                    std::min(joint.effort, std::abs(joint.gear) * std::max(std::abs(range[0]), std::abs(range[1])));
        }
    }

    void read_equality(pugi::xml_node node)
    {
        input_.apply_defaults(node, "");
        if (!node.attribute("active").as_bool(true)) return;
        const std::string kind = node.name();
        RobotClosure closure;
        closure.place = input_.file.place(node);
        closure.what = "<" + kind + "> of <equality>";
        const auto body = [&](const char* key) {
            const auto found = body_of_.find(node.attribute(key).as_string());
            return found == body_of_.end() ? -1 : found->second;
        };
        const auto joint = [&](const char* key) {
            const std::string name = node.attribute(key).as_string();
            for (std::size_t j = 0; j < robot_.joints.size(); ++j)
                if (!name.empty() && robot_.joints[j].name == name) return static_cast<int>(j);
            return -1;
        };
        if (kind == "connect" || kind == "weld") closure.a = body("body1"), closure.b = body("body2");
        if (kind == "joint") closure.first = joint("joint1"), closure.second = joint("joint2");
        if (std::max({closure.a, closure.b, closure.first, closure.second}) >= 0) robot_.closures.push_back(closure);
    }

    MjcfInput input_;
    Robot robot_;
    std::map<std::string, int> body_of_;
};

}  // namespace

Robot read_mjcf(const std::filesystem::path& path)
{
    return MjcfReader(path).read();
}

}  // namespace stickslip::files
