#include "sweep/files/robots/mjcf_input.h"

#include <cctype>
#include <numbers>

namespace stickslip::files {

namespace {

/// Puts the children of each included file in the place of its <include>.
void include(XmlFile& file, pugi::xml_node node, const std::filesystem::path& folder, int depth)
{
    if (depth > 10) file.fail(node, "includes itself");
    for (auto child = node.first_child(); child;) {
        const auto next = child.next_sibling();
        if (std::string(child.name()) == "include") {
            XmlFile other(folder / file.required(child, "file"));
            include(other, other.root(), folder, depth + 1);
            for (const auto& part : other.root().children()) file.insert_before(child, other, part);
            node.remove_child(child);
        } else {
            include(file, child, folder, depth);
        }
        child = next;
    }
}

}  // namespace

MjcfInput::MjcfInput(XmlFile xml, const std::filesystem::path& folder) : file(std::move(xml))
{
    include(file, file.root(), folder, 0);
    read_compiler();
    read_flags();
    for (const auto& element : file.root().children("default")) collect(element, "");
    for (const char* element : {"deformable", "composite"})
        if (const auto node = file.root().child(element)) file.fail(node, "is not supported");
}

void MjcfInput::read_compiler()
{
    for (const auto& compiler : file.root().children("compiler")) {
        const std::string unit = compiler.attribute("angle").as_string(degrees ? "degree" : "radian");
        degrees = unit == "degree";
        sequence_ = compiler.attribute("eulerseq").as_string(sequence_.c_str());
        autolimits = compiler.attribute("autolimits").as_bool(autolimits);
        inertia_from_geoms = compiler.attribute("inertiafromgeom").as_string(inertia_from_geoms.c_str());
        if (const auto groups = file.numbers(compiler, "inertiagrouprange"); groups.size() == 2)
            first_group = groups[0], last_group = groups[1];
        for (const char* name : {"settotalmass", "boundmass", "boundinertia", "balanceinertia"})
            if (compiler.attribute(name).as_double(0) > 0 || compiler.attribute(name).as_bool(false))
                file.fail(compiler, std::string(name) + " changes masses and is not supported; state the inertias");
        if (compiler.attribute("coordinate").as_string("local") != std::string("local"))
            file.fail(compiler, "coordinate is not \"local\"");
    }
}

void MjcfInput::read_flags()
{
    for (const auto& option : file.root().children("option"))
        for (const auto& flag : option.children("flag"))
            for (const auto& part : flag.attributes()) {
                if (std::string(part.value()) == "disable")
                    disabled_.insert(part.name());
                else
                    disabled_.erase(part.name());
            }
}

void MjcfInput::collect(const pugi::xml_node& element, const std::string& parent)
{
    const std::string name = element.attribute("class").as_string(parent.empty() ? "main" : "");
    classes_[name] = element;
    if (name != "main") parents_[name] = parent.empty() ? "main" : parent;
    for (const auto& child : element.children("default")) collect(child, name);
}

std::vector<pugi::xml_node> MjcfInput::defaults_of(const pugi::xml_node& node, const std::string& childclass) const
{
    const std::string given = node.attribute("class").as_string(childclass.empty() ? "main" : childclass.c_str());
    if (!classes_.count(given) && given != "main")
        file.fail(node, "names the default class \"" + given + "\", which does not exist");
    std::vector<pugi::xml_node> defaults;
    for (std::string name = given; !name.empty();) {
        if (const auto found = classes_.find(name); found != classes_.end()) defaults.push_back(found->second);
        const auto parent = parents_.find(name);
        name = parent == parents_.end() ? "" : parent->second;
    }
    return defaults;
}

void MjcfInput::apply_defaults(pugi::xml_node node, const std::string& childclass) const
{
    apply_defaults(node, childclass, node.name());
}

void MjcfInput::apply_defaults(pugi::xml_node node, const std::string& childclass, const char* as) const
{
    for (const auto& defaults : defaults_of(node, childclass))
        for (const auto& attribute : defaults.child(as).attributes())
            if (!node.attribute(attribute.name())) node.append_copy(attribute);
}

double MjcfInput::angle(double written) const
{
    return degrees ? written * std::numbers::pi / 180 : written;
}

Eigen::Matrix3d MjcfInput::orientation(const pugi::xml_node& node) const
{
    using Eigen::Vector3d;
    const auto read = [&](const char* name, std::size_t count) {
        const auto values = file.numbers(node, name);
        if (values.size() != count) file.fail(node, std::string(name) + " needs " + std::to_string(count) + " numbers");
        return values;
    };
    if (node.attribute("quat")) {
        const auto q = read("quat", 4);
        return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
    }
    if (node.attribute("axisangle")) {
        const auto a = read("axisangle", 4);
        return Eigen::AngleAxisd(angle(a[3]), Vector3d(a[0], a[1], a[2]).normalized()).toRotationMatrix();
    }
    if (node.attribute("euler")) {
        const auto e = read("euler", 3);
        Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
        for (std::size_t i = 0; i < 3; ++i) {
            const char letter = sequence_[i];
            const Vector3d axis = Vector3d::Unit(std::tolower(letter) - 'x');
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle(e[i]), axis).toRotationMatrix();
            R = std::islower(letter) ? R * turn : turn * R;
        }
        return R;
    }
    if (node.attribute("xyaxes")) {
        const auto a = read("xyaxes", 6);
        const Vector3d x = Vector3d(a[0], a[1], a[2]).normalized();
        const Vector3d rough(a[3], a[4], a[5]), y = (rough - rough.dot(x) * x).normalized();
        Eigen::Matrix3d R;
        R << x, y, x.cross(y);
        return R;
    }
    if (node.attribute("zaxis"))
        return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), file.vector(node, "zaxis", {0, 0, 1}))
            .toRotationMatrix();
    return Eigen::Matrix3d::Identity();
}

Eigen::Isometry3d MjcfInput::frame(const pugi::xml_node& node) const
{
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translate(file.vector(node, "pos", {0, 0, 0}));
    frame.rotate(orientation(node));
    return frame;
}

}  // namespace stickslip::files
