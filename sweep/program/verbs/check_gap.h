// stickslip check of a joint and its records: has the sim-to-real gap become worse than in the baseline?
#pragma once
#include "sweep/program/verbs/log_options.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/study/check/gap_check.h"

#include <string>
#include <vector>

namespace stickslip {

struct GapCheckQuestion {
    std::string joint, baseline, junit, directory;
    std::vector<std::string> records;  ///< files, or folders of them
    std::string name;                  ///< of the joint in logs of several
    LogOptions how;
    GapTolerance tolerance;
    int threads = 0;
    bool update = false, json = false;
};

int check_gap(const GapCheckQuestion& question, const Invocation& invocation);

}  // namespace stickslip
