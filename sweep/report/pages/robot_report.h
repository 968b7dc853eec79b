// The page of a robot: joints against causes, each row leading to the page of its joint.
#pragma once
#include "analysis/results/report.h"
#include "analysis/results/table_marks.h"
#include "sweep/study/robot_answer.h"

#include <string>
#include <utility>
#include <vector>

namespace stickslip {

struct RobotPage {
    Report report;
    TableMarks marks;
};

/// `linked`: the joints have pages of their own, NAME/report.html from here.
RobotPage robot_report(const RobotAnswer& robot, std::vector<std::pair<std::string, std::string>> provenance,
                       bool linked = true);

}  // namespace stickslip
