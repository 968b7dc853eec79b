// MJCF: the tree of bodies, joints, actuators and equalities. https://mujoco.readthedocs.io/en/stable/XMLreference.html
#include "sweep/files/robots/mjcf_actuator.h"
#include "sweep/files/robots/mjcf_forces.h"
#include "sweep/files/robots/mjcf_inertia.h"
#include "sweep/files/robots/robot_xml.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {
namespace {

class MjcfReader {
  public:
    explicit MjcfReader(MjcfInput input) : input_(std::move(input)) {}

    Robot read()
    {
        const auto root = input_.file.root();
        for (const auto& option : root.children("option")) read_option(option);
        if (!input_.acts("gravity")) robot_.gravity.setZero();
        std::vector<SolidPart> of_the_world;
        for (const auto& world : root.children("worldbody"))
            contents(world, -1, "", Eigen::Isometry3d::Identity(), of_the_world);
        if (robot_.bodies.empty()) input_.file.fail(root, "has no <worldbody> with bodies");
        read_tendons(input_, names_, robot_);
        read_actuators(input_, names_, robot_);
        for (const auto& list : root.children("equality"))
            for (const auto& equality : list.children()) read_equality(equality);
        return std::move(robot_);
    }

  private:
    void read_option(const pugi::xml_node& option)
    {
        robot_.gravity = input_.file.vector(option, "gravity", robot_.gravity);
        if (!any_number(input_, option, "density") && !any_number(input_, option, "viscosity")) return;
        robot_.not_taken.push_back(not_taken(input_, NotTakenReason::medium, option, {"density", "viscosity", "wind"}));
        robot_.not_taken.back().every_joint = true;
    }

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
                const double group = input_.file.number(child, "group", 0);
                const bool counts = group >= input_.first_group && group <= input_.last_group;
                if (counts && (!child.parent().child("inertial") || input_.inertia_from_geoms == "true"))
                    geoms.push_back(placed(geom_part(input_, child), frame));
            } else if (name == "site") {
                names_.sites[child.attribute("name").as_string()] = body;
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
        body.held_weight = input_.file.number(node, "gravcomp", 0);
        names_.bodies[node.attribute("name").as_string()] = index;
        robot_.bodies.push_back(body);
        std::vector<SolidPart> parts;
        const auto inertial = node.child("inertial");
        const bool own = inertial && input_.inertia_from_geoms != "true";
        contents(node, index, node.attribute("childclass").as_string(childclass.c_str()), Eigen::Isometry3d::Identity(),
                 parts);
        if (own) parts = {inertial_part(input_, inertial)};
        set_inertia(robot_.bodies[static_cast<std::size_t>(index)], parts);
    }

    /// Of a joint that comes next: its effort is limited alike in both directions.
    void take_effort_range(const pugi::xml_node& node, const MjcfRange& range, RobotJoint& joint)
    {
        joint.effort = range.greatest;
        if (!range.lopsided) return;
        robot_.not_taken.push_back(not_taken(input_, NotTakenReason::lopsided, node, {"actuatorfrcrange"}));
        robot_.not_taken.back().joints = {static_cast<int>(robot_.joints.size())};
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
        joint.armature = first("armature");
        if (input_.acts("frictionloss")) joint.friction = first("frictionloss");
        const int index = static_cast<int>(robot_.joints.size());
        read_passive(node, index, joint);
        if (const auto range = input_.file.numbers(node, "range");
            range.size() == 2 && input_.limited(node.attribute("limited").as_string("auto"))) {
            joint.low = coordinate(range[0]);
            joint.high = coordinate(range[1]);
        }
        if (const auto range = input_.file.numbers(node, "actuatorfrcrange");
            range.size() == 2 && input_.limited(node.attribute("actuatorfrclimited").as_string("auto")))
            take_effort_range(node, range_of(range), joint);
        robot_.bodies[static_cast<std::size_t>(body)].joints.push_back(index);
        robot_.joints.push_back(joint);
    }

    /// Spring and damper to the parent, and what of them a joint of ours does not have.
    void read_passive(const pugi::xml_node& node, int index, RobotJoint& joint)
    {
        const auto leave_out = [&](NotTakenReason reason, const std::vector<const char*>& attributes) {
            robot_.not_taken.push_back(not_taken(input_, reason, node, attributes));
            robot_.not_taken.back().joints = {index};
        };
        const auto both = input_.file.numbers(node, "springdamper"), damping = input_.file.numbers(node, "damping");
        const bool by_time = both.size() == 2 && both[0] > 0 && both[1] > 0;  // in the place of both coefficients
        if (input_.acts("spring") && (by_time || any_number(input_, node, "stiffness")))
            leave_out(NotTakenReason::spring, {"stiffness", "springref", "springdamper"});
        if (by_time || damping.empty() || !input_.acts("damper")) return;
        joint.damping = damping[0];
        if (std::any_of(damping.begin() + 1, damping.end(), [](double c) { return c != 0; }))
            leave_out(NotTakenReason::nonlinear, {"damping"});
    }

    void read_equality(pugi::xml_node node)
    {
        input_.apply_defaults(node, "", "equality");
        if (!node.attribute("active").as_bool(true)) return;
        const std::string kind = node.name();
        RobotClosure closure;
        closure.place = input_.file.place(node);
        closure.what = "<" + kind + "> of <equality>";
        const auto named = [&](const std::map<std::string, int>& of, const char* key) {
            const auto found = of.find(node.attribute(key).as_string());
            return found == of.end() ? -1 : found->second;
        };
        const auto joint = [&](const char* key) { return index_of_joint(robot_, node.attribute(key).as_string()); };
        if (kind == "connect" || kind == "weld") {
            closure.a = std::max(named(names_.bodies, "body1"), named(names_.sites, "site1"));
            closure.b = std::max(named(names_.bodies, "body2"), named(names_.sites, "site2"));
        }
        if (kind == "joint") closure.first = joint("joint1"), closure.second = joint("joint2");
        if (kind == "tendon") return tie_tendons(node, closure);
        if (std::max({closure.a, closure.b, closure.first, closure.second}) >= 0) robot_.closures.push_back(closure);
    }

    /// A sum of coordinates that is tied leaves none of its joints free.
    void tie_tendons(const pugi::xml_node& node, RobotClosure closure)
    {
        for (const char* key : {"tendon1", "tendon2"}) {
            const auto found = names_.tendons.find(node.attribute(key).as_string());
            if (found == names_.tendons.end()) continue;
            for (const int joint : found->second.joints) {
                closure.first = joint;
                robot_.closures.push_back(closure);
            }
            if (!found->second.spatial) continue;
            robot_.not_taken.push_back(not_taken(input_, NotTakenReason::coupling, node, {"tendon1", "tendon2"}));
            robot_.not_taken.back().every_joint = true;
        }
    }

    MjcfInput input_;
    Robot robot_;
    MjcfNames names_;
};

}  // namespace

Robot read_mjcf(XmlFile file, const std::filesystem::path& folder)
{
    return MjcfReader(MjcfInput(std::move(file), folder)).read();
}

}  // namespace stickslip::files
