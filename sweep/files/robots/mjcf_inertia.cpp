#include "sweep/files/robots/mjcf_inertia.h"

#include <algorithm>
#include <numbers>

namespace stickslip::files {
namespace {

using std::numbers::pi;

/// Volume, and principal inertias of a body of unit mass.
struct Shape {
    double volume = 0;
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
};

Shape capsule(double r, double h)
{
    const double cylinder = pi * r * r * 2 * h, ball = 4. / 3 * pi * r * r * r, whole = cylinder + ball;
    const double c = cylinder / whole, s = ball / whole;
    // half balls at both ends: their centres lie 3/8 r beyond the cylinder
    const double across = c * (r * r / 4 + h * h / 3) + s * (0.4 * r * r + h * h + 0.75 * h * r);
    return {whole, {across, across, (c / 2 + 0.4 * s) * r * r}};
}

Shape shape_of(const MjcfInput& input, const pugi::xml_node& geom, const std::string& type,
               const std::vector<double>& size)
{
    const auto need = [&](std::size_t count) {
        if (size.size() < count)
            input.file.fail(geom, "size needs " + std::to_string(count) + " numbers for a " + type);
    };
    if (type == "sphere") {
        need(1);
        return {4. / 3 * pi * size[0] * size[0] * size[0], Eigen::Vector3d::Constant(0.4 * size[0] * size[0])};
    }
    if (type == "capsule") return need(2), capsule(size[0], size[1]);
    if (type == "cylinder") {
        need(2);
        const double r = size[0], h = size[1], across = r * r / 4 + h * h / 3;
        return {pi * r * r * 2 * h, {across, across, r * r / 2}};
    }
    if (type == "box" || type == "ellipsoid") {
        need(3);
        const double x = size[0] * size[0], y = size[1] * size[1], z = size[2] * size[2];
        const bool box = type == "box";
        const double share = box ? 1. / 3 : 0.2;
        return {(box ? 8 : 4. / 3 * pi) * size[0] * size[1] * size[2], Eigen::Vector3d(y + z, x + z, x + y) * share};
    }
    input.file.fail(geom,
                    "is a " + type + " and its body has no <inertial>; state mass and inertia there, or mass=\"0\"");
}

}  // namespace

SolidPart inertial_part(const MjcfInput& input, const pugi::xml_node& inertial)
{
    SolidPart part;
    input.file.required(inertial, "mass");
    part.mass = input.file.number(inertial, "mass", 0);
    part.centre = input.file.vector(inertial, "pos", {0, 0, 0});
    const auto full = input.file.numbers(inertial, "fullinertia");
    if (full.size() == 6) {
        part.inertia << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
    } else {
        input.file.required(inertial, "diaginertia");
        const Eigen::Matrix3d R = input.orientation(inertial);
        part.inertia = R * input.file.vector(inertial, "diaginertia", {0, 0, 0}).asDiagonal() * R.transpose();
    }
    check_inertia(input.file, inertial, part.mass, part.inertia);
    return part;
}

SolidPart geom_part(const MjcfInput& input, const pugi::xml_node& geom)
{
    const std::string type = geom.attribute("type").as_string(geom.attribute("mesh") ? "mesh" : "sphere");
    const bool weightless = (geom.attribute("mass") && input.file.number(geom, "mass", 0) == 0) ||
                            (!geom.attribute("mass") && input.file.number(geom, "density", 1000) == 0);
    SolidPart part;
    if (type == "plane" || type == "hfield" || weightless) return part;
    if (geom.attribute("shellinertia").as_bool(false)) input.file.fail(geom, "shellinertia is not supported");
    auto size = input.file.numbers(geom, "size");
    Eigen::Isometry3d frame = input.frame(geom);
    if (const auto ends = input.file.numbers(geom, "fromto"); ends.size() == 6) {
        const Eigen::Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
        frame = Eigen::Isometry3d::Identity();
        frame.translate(0.5 * (from + to));
        frame.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), from - to));
        const std::size_t along = type == "box" || type == "ellipsoid" ? 2 : 1;
        while (size.size() <= along) size.push_back(size.empty() ? 0 : size.back());
        size[along] = 0.5 * (to - from).norm();
    }
    const Shape shape = shape_of(input, geom, type, size);
    part.mass = input.file.number(geom, "mass", shape.volume * input.file.number(geom, "density", 1000));
    part.centre = frame.translation();
    const Eigen::Matrix3d R = frame.linear();
    part.inertia = R * (part.mass * shape.inertia).asDiagonal() * R.transpose();
    return part;
}

SolidPart placed(SolidPart part, const Eigen::Isometry3d& frame)
{
    part.centre = frame * part.centre;
    part.inertia = frame.linear() * part.inertia * frame.linear().transpose();
    return part;
}

void set_inertia(RobotBody& body, const std::vector<SolidPart>& parts)
{
    for (const auto& part : parts) {
        body.mass += part.mass;
        body.centre += part.mass * part.centre;
    }
    if (body.mass > 0) body.centre /= body.mass;
    for (const auto& part : parts) {
        const Eigen::Vector3d d = part.centre - body.centre;
        body.inertia += part.inertia + part.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
    }
}

}  // namespace stickslip::files
