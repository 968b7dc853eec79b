// Mass and inertia of a body of MJCF: its own <inertial>, or its geoms. Internal to sweep/files.
#pragma once
#include "sweep/files/robots/mjcf_input.h"
#include "sweep/study/import/robot.h"

namespace stickslip::files {

struct SolidPart {
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about its own centre, axes of the body
};

/// <inertial>: mass, pos, diaginertia with an orientation, or fullinertia.
SolidPart inertial_part(const MjcfInput& input, const pugi::xml_node& inertial);

/// A geom of even density. Throws BadInput for shapes whose volume stands in another file (meshes).
SolidPart geom_part(const MjcfInput& input, const pugi::xml_node& geom);

/// Moves the part with the frame that it was given in.
SolidPart placed(SolidPart part, const Eigen::Isometry3d& frame);

/// All parts as one (Steiner).
void set_inertia(RobotBody& body, const std::vector<SolidPart>& parts);

}  // namespace stickslip::files
