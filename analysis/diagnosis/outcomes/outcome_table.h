// Measured outcomes: at which settings a real joint slid smoothly and at which it stuck and slipped.
#pragma once
#include "analysis/joint/joint.h"

#include <cstdint>
#include <string>
#include <vector>

namespace stickslip {

struct OutcomeRow {
    std::vector<double> settings;  ///< SI, one for each path of the table
    bool stick_slip = false;
    double amplitude = not_set;  ///< of the stick-slip in position, half peak to peak; m | rad
    std::uint64_t line = 0;      ///< of the file, for messages
};

/// Rows of one joint; each was started from rest by commanding its velocity.
struct OutcomeTable {
    std::string name;                ///< file name, for reports
    std::vector<std::string> paths;  ///< "control.k_p": what the rows set of the joint
    std::vector<OutcomeRow> rows;
};

}  // namespace stickslip
