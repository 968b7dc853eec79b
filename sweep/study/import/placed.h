// Where the bodies and axes of a robot are at a pose. Internal to sweep/study/import.
#pragma once
#include "sweep/study/import/robot.h"

#include <vector>

namespace stickslip {

/// In the world.
struct Placed {
    std::vector<Eigen::Isometry3d> body;
    std::vector<Eigen::Vector3d> axis, anchor;  ///< by joint
};

Placed place(const Robot& robot, const std::vector<double>& pose);

}  // namespace stickslip
