// URDF: links and joints, a tree by its own rules. https://wiki.ros.org/urdf/XML
#include "sweep/files/robots/robot_xml.h"
#include "sweep/files/robots/xml_input.h"

#include <map>

namespace stickslip::files {
namespace {

/// rpy: about the fixed axes x, y, z in this order.
Eigen::Isometry3d origin(const XmlFile& file, const pugi::xml_node& of)
{
    const auto node = of.child("origin");
    const Eigen::Vector3d xyz = file.vector(node, "xyz", {0, 0, 0}), rpy = file.vector(node, "rpy", {0, 0, 0});
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translate(xyz);
    frame.rotate(Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                 Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                 Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()));
    return frame;
}

void read_inertial(const XmlFile& file, const pugi::xml_node& link, RobotBody& body)
{
    const auto inertial = link.child("inertial");
    if (!inertial) return;
    const auto mass = inertial.child("mass"), inertia = inertial.child("inertia");
    if (!mass || !inertia) file.fail(inertial, "of " + body.name + " needs <mass> and <inertia>");
    for (const char* name : {"ixx", "iyy", "izz"}) file.required(inertia, name);
    file.required(mass, "value");
    const auto I = [&](const char* name) { return file.number(inertia, name, 0); };
    Eigen::Matrix3d own;
    own << I("ixx"), I("ixy"), I("ixz"), I("ixy"), I("iyy"), I("iyz"), I("ixz"), I("iyz"), I("izz");
    const auto frame = origin(file, inertial);
    body.mass = file.number(mass, "value", 0);
    check_inertia(file, inertia, body.mass, own);
    body.centre = frame.translation();
    body.inertia = frame.linear() * own * frame.linear().transpose();
}

RobotJoint read_joint_element(const XmlFile& file, const pugi::xml_node& node)
{
    RobotJoint joint;
    joint.name = file.required(node, "name");
    joint.place = file.place(node);
    const std::string type = file.required(node, "type");
    if (type == "revolute" || type == "continuous")
        joint.kind = RobotJointKind::hinge;
    else if (type == "prismatic")
        joint.kind = RobotJointKind::slide;
    else if (type == "fixed" || type == "floating")
        joint.kind = RobotJointKind::fixed;  // a floating base stands where it is drawn
    else
        file.fail(node, "is of type \"" + type + "\", expected revolute, continuous, prismatic, fixed, floating");
    if (joint.kind == RobotJointKind::fixed) return joint;
    joint.axis = file.vector(node.child("axis"), "xyz", Eigen::Vector3d::UnitX());
    if (joint.axis.norm() == 0) file.fail(node.child("axis"), "has no direction");
    joint.axis.normalize();
    joint.damping = file.number(node.child("dynamics"), "damping", 0);
    joint.friction = file.number(node.child("dynamics"), "friction", 0);
    if (const auto limit = node.child("limit")) {
        if (type != "continuous") {
            joint.low = file.number(limit, "lower", 0);
            joint.high = file.number(limit, "upper", 0);
        }
        joint.effort = file.number(limit, "effort", infinity);
        joint.velocity = file.number(limit, "velocity", infinity);
    }
    return joint;
}

/// What hangs on a link, placed behind it so that bodies follow their parents.
class TreeBuilder {
  public:
    TreeBuilder(const XmlFile& file, Robot& robot) : file_(file), robot_(robot) {}

    void read()
    {
        for (const auto& link : file_.root().children("link"))
            if (!links_.emplace(file_.required(link, "name"), link).second) file_.fail(link, "appears twice");
        for (const auto& node : file_.root().children("joint")) {
            const std::string parent = file_.required(node.child("parent"), "link");
            const std::string child = file_.required(node.child("child"), "link");
            for (const auto& name : {parent, child})
                if (!links_.count(name)) file_.fail(node, "names the link \"" + name + "\", which does not exist");
            if (const auto [other, is_new] = into_.emplace(child, node); !is_new)
                file_.fail(node, "closes a loop: link \"" + child + "\" hangs on joint \"" +
                                     other->second.attribute("name").as_string() + "\" already, expected a tree");
            from_[parent].push_back(node);
        }
        for (const auto& [name, link] : links_)
            if (!into_.count(name)) add(link, -1, {});
        if (robot_.bodies.size() < links_.size())
            for (const auto& [name, node] : into_)
                if (!placed_.count(name))
                    file_.fail(node, "lies in a loop: its links hang on each other, expected a tree");
    }

  private:
    void add(const pugi::xml_node& link, int parent, const pugi::xml_node& by)
    {
        const int index = static_cast<int>(robot_.bodies.size());
        RobotBody body;
        body.name = "link \"" + std::string(link.attribute("name").as_string()) + "\"";
        body.parent = parent;
        body.place = file_.place(link);
        read_inertial(file_, link, body);
        if (by) {
            body.frame = origin(file_, by);
            RobotJoint joint = read_joint_element(file_, by);
            joint.body = index;
            if (joint.kind != RobotJointKind::fixed) {
                body.joints.push_back(static_cast<int>(robot_.joints.size()));
                robot_.joints.push_back(joint);
            }
        }
        const std::string name = link.attribute("name").as_string();
        placed_[name] = index;
        robot_.bodies.push_back(std::move(body));
        for (const auto& node : from_[name])
            add(links_[node.child("child").attribute("link").as_string()], index, node);
    }

    const XmlFile& file_;
    Robot& robot_;
    std::map<std::string, pugi::xml_node> links_, into_;
    std::map<std::string, std::vector<pugi::xml_node>> from_;
    std::map<std::string, int> placed_;
};

/// <mimic>: a joint whose coordinate follows that of another.
void read_mimics(const XmlFile& file, Robot& robot)
{
    const auto index = [&](const std::string& name) {
        for (std::size_t j = 0; j < robot.joints.size(); ++j)
            if (robot.joints[j].name == name) return static_cast<int>(j);
        return -1;
    };
    for (const auto& node : file.root().children("joint")) {
        const auto mimic = node.child("mimic");
        const int follows = index(node.attribute("name").as_string());
        if (!mimic || follows < 0) continue;
        const std::string leader = file.required(mimic, "joint");
        RobotClosure closure;
        closure.first = follows;
        closure.second = index(leader);
        if (closure.second < 0) file.fail(mimic, "names the joint \"" + leader + "\", which does not exist or move");
        closure.place = file.place(mimic);
        closure.what = "<mimic> of joint \"" + robot.joints[static_cast<std::size_t>(follows)].name + "\"";
        robot.closures.push_back(closure);
    }
}

/// What xacro has not yet put into links and joints would be missing without a word.
void refuse_xacro(const XmlFile& file)
{
    for (const auto& node : file.root().children())
        if (std::string(node.name()).rfind("xacro:", 0) == 0)
            file.fail(node, "is xacro's; run xacro on this file first");
}

NotTaken left_out(const XmlFile& file, NotTakenReason reason, const pugi::xml_node& node, int joint)
{
    NotTaken element;
    element.reason = reason;
    element.place = file.place(node);
    element.element = node.name();
    element.joints = {joint};
    return element;
}

void add_attribute(NotTaken& element, const char* name, const char* value)
{
    if (!element.attributes.empty()) element.attributes += ' ';
    element.attributes += std::string(name) + "=\"" + value + "\"";
}

/// What acts on a joint and has no place in a joint of ours: limits near the ends of travel, springs of Gazebo.
void read_what_is_left_out(const XmlFile& file, Robot& robot)
{
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
        const auto& name = robot.joints[j].name;
        const int index = static_cast<int>(j);
        const auto node = file.root().find_child_by_attribute("joint", "name", name.c_str());
        if (const auto safety = node.child("safety_controller")) {
            auto element = left_out(file, NotTakenReason::safety, safety, index);
            for (const auto& attribute : safety.attributes())
                add_attribute(element, attribute.name(), attribute.value());
            robot.not_taken.push_back(element);
        }
        for (const auto& gazebo : file.root().children("gazebo")) {
            const auto spring = gazebo.child("springStiffness");
            if (gazebo.attribute("reference").as_string() != name || spring.text().as_double() == 0) continue;
            auto element = left_out(file, NotTakenReason::spring, spring, index);
            for (const char* part : {"springStiffness", "springReference"})
                if (const auto value = gazebo.child(part)) add_attribute(element, part, value.text().as_string());
            robot.not_taken.push_back(element);
        }
    }
}

/// <transmission>: how many turns the motor makes a turn of the joint.
void read_gears(const XmlFile& file, Robot& robot)
{
    for (const auto& node : file.root().children("transmission")) {
        const std::string name = node.child("joint").attribute("name").as_string();
        const auto reduction = node.child("actuator").child("mechanicalReduction");
        for (auto& joint : robot.joints)
            if (joint.name == name && reduction) joint.gear = reduction.text().as_double(1);
    }
}

}  // namespace

Robot read_urdf(const XmlFile& file)
{
    refuse_xacro(file);
    Robot robot;
    TreeBuilder(file, robot).read();
    read_mimics(file, robot);
    read_gears(file, robot);
    read_what_is_left_out(file, robot);
    return robot;
}

}  // namespace stickslip::files
