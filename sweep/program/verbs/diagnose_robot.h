// stickslip diagnose --all-joints: every joint of a robot from the same logs.
#pragma once
#include "sweep/files/records/joint_log.h"
#include "sweep/program/verbs/verbs.h"

#include <string>
#include <vector>

namespace stickslip {

struct RobotQuestion {
    std::string robot, directory;
    std::vector<std::string> logs, only;  ///< only: names of joints; empty for all
    LogOptions how;
    int threads = 0;
    bool json = false, no_report = false;
};

/// One joint after the other; a joint that cannot be diagnosed does not stop the others. Returns the exit code: 3
/// interrupted, else 2 where a joint was refused, else 4 where records say too little, else 0.
int diagnose_robot(const RobotQuestion& question, const Invocation& invocation);

}  // namespace stickslip
