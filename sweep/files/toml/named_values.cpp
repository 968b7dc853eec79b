#include "sweep/files/toml/named_values.h"

#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/struct_reader.h"

#include <algorithm>
#include <tuple>

namespace stickslip::files {
namespace {

void flatten(const toml::table& table, const std::string& prefix, const std::vector<std::string>& leaf_keys,
             std::vector<std::tuple<unsigned, unsigned, NamedValue>>& found)
{
    for (auto&& [key, node] : table) {
        const std::string path = prefix.empty() ? std::string(key.str()) : prefix + "." + std::string(key.str());
        const auto* inner = node.as_table();
        const bool value = !inner || std::any_of(leaf_keys.begin(), leaf_keys.end(),
                                                 [&](const auto& k) { return inner->contains(k); });
        const Place place(key.source());
        if (value || inner->empty())
            found.emplace_back(place.line, place.column, NamedValue{path, place, &node});
        else
            flatten(*inner, path, leaf_keys, found);
    }
}

/// Inertia and gravity of a joint that stands in a robot.
bool follows_from_pose(const Joint& joint, const double* number)
{
    const auto& m = joint.mechanism;
    const auto& load = joint.load;
    return joint.pose.of &&
           (number == &m.inertia || number == &m.link_inertia || number == &load.gravity_amplitude ||
            number == &load.gravity_phase || (m.motion == Motion::prismatic && number == &load.constant));
}

std::string unknown(const Joint& joint, const std::string& path)
{
    if (!path.starts_with("pose.")) return "is not a parameter of this joint";
    if (!joint.pose.of) return "is a pose, which needs a [robot] table with file and joint";
    std::vector<std::string> names;
    for (const auto& other : joint.pose.of->neighbours) names.push_back("pose." + other.name);
    return "is none of the other joints of the robot, expected " + listed(names);
}

}  // namespace

std::vector<NamedValue> dotted_values(const toml::table& table, const std::vector<std::string>& leaf_keys,
                                      const std::vector<std::string>& skip)
{
    std::vector<std::tuple<unsigned, unsigned, NamedValue>> found;
    flatten(table, "", leaf_keys, found);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::pair(std::get<0>(a), std::get<1>(a)) < std::pair(std::get<0>(b), std::get<1>(b));
    });
    std::vector<NamedValue> values;
    for (auto& [line, column, value] : found) {
        const std::string first = value.path.substr(0, value.path.find('.'));
        if (std::find(skip.begin(), skip.end(), first) == skip.end()) values.push_back(std::move(value));
    }
    return values;
}

std::optional<Parameter> find_leaf(Joint& joint, const std::string& path, const Place& place, std::string_view prefix,
                                   Complaints& complaints)
{
    const double* value = find_parameter(joint, path);
    if (follows_from_pose(joint, value)) {
        complaints.add(place, std::string(prefix) + "." + path,
                       "follows from the pose of [robot], expected another number, or the pose of another joint");
        return {};
    }
    for (const auto& p : parameters(joint))
        if (p.value == value && value) return p;
    complaints.add(place, std::string(prefix) + "." + path,
                   unknown(joint, path) + did_you_mean(path, numeric_paths(joint)));
    return {};
}

std::optional<double> read_value(const toml::node& node, const Parameter& leaf, Units units, const Place& fallback,
                                 const std::string& path, Complaints& complaints)
{
    const Field field{leaf.path, leaf.quantity, leaf.range, leaf.need, leaf.help};
    double value = 0;
    if (const std::string problem = read_number(node, field, units, value); !problem.empty()) {
        complaints.add(Place(node.source()).or_else(fallback), path, problem);
        return {};
    }
    return value;
}

}  // namespace stickslip::files
