// The page of a set point that is held without hunting.
#pragma once
#include "analysis/results/report.h"
#include "analysis/results/set_point_design.h"
#include "sweep/study/set_point_scan.h"

#include <string>
#include <vector>

namespace stickslip {

struct SetPointDesignAnswer {
    std::string command;
    Joint joint;                   ///< as given
    double friction_margin = 0;    ///< share by which friction may be off
    double rest_error = infinity;  ///< that is allowed
    SetPointDesign design;
    SetPointScan scan;
};

/// `snippets`: the lines to take into the joint file, and the file.
Report set_point_design_report(const SetPointDesignAnswer& answer, std::vector<Snippet> snippets);

}  // namespace stickslip
