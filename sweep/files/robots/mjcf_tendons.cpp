#include "sweep/files/robots/mjcf_forces.h"

#include <algorithm>

namespace stickslip::files {

int index_of_joint(const Robot& robot, const std::string& name)
{
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
        if (!name.empty() && robot.joints[j].name == name) return static_cast<int>(j);
    return -1;
}

NotTaken not_taken(const MjcfInput& input, NotTakenReason reason, const pugi::xml_node& node,
                   const std::vector<const char*>& attributes)
{
    NotTaken element;
    element.reason = reason;
    element.place = input.file.place(node);
    element.element = node.name();
    element.name = node.attribute("name").as_string();
    for (const char* name : attributes) {
        const auto attribute = node.attribute(name);
        if (!attribute) continue;
        if (!element.attributes.empty()) element.attributes += ' ';
        element.attributes += std::string(name) + "=\"" + attribute.as_string() + "\"";
    }
    return element;
}

bool any_number(const MjcfInput& input, const pugi::xml_node& node, const char* name)
{
    const auto values = input.file.numbers(node, name);
    return std::ranges::any_of(values, [](double value) { return value != 0; });
}

void read_tendons(const MjcfInput& input, MjcfNames& names, Robot& robot)
{
    for (const auto& list : input.file.root().children("tendon"))
        for (pugi::xml_node node : list.children()) {
            input.apply_defaults(node, "", "tendon");
            MjcfTendon tendon;
            tendon.spatial = std::string(node.name()) == "spatial";
            for (const auto& part : node.children("joint"))
                if (const int j = index_of_joint(robot, part.attribute("joint").as_string()); j >= 0)
                    tendon.joints.push_back(j);
            names.tendons[node.attribute("name").as_string()] = tendon;
            const bool pulls = any_number(input, node, "stiffness") && input.acts("spring");
            const bool damps = any_number(input, node, "damping") && input.acts("damper");
            const bool rubs = any_number(input, node, "frictionloss") && input.acts("frictionloss");
            const bool stops = node.attribute("range") && input.limited(node.attribute("limited").as_string("auto"));
            if (!pulls && !damps && !rubs && !stops && !any_number(input, node, "armature")) continue;
            auto coupling = not_taken(input, NotTakenReason::coupling, node,
                                      {"stiffness", "springlength", "damping", "frictionloss", "armature", "range"});
            coupling.every_joint = tendon.spatial;
            // a joint that carries another moves with what ties that one: the other does not stand still behind it
            for (const int j : tendon.joints) coupling.bodies.push_back(robot.joints[static_cast<std::size_t>(j)].body);
            robot.not_taken.push_back(coupling);
        }
}

}  // namespace stickslip::files
