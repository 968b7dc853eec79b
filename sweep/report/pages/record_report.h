// The page of a joint that followed a reference: the command, what it did, and with which effort.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// Row by row in time; the last may be empty.
struct FollowedReference {
    std::vector<double> time, reference_position, position, effort_command, effort_measured;
    std::string ends_early;  ///< why; empty where it does not
    std::string loop = {};   ///< what is wrong with the loop, as a sentence; empty: nothing
};

Report record_report(const Joint& joint, const FollowedReference& record);

}  // namespace stickslip
