// A robot's diagnosis in plain words.
#pragma once
#include "sweep/study/robot_answer.h"

#include <string>

namespace stickslip {

/// "3 of 6 joints differ from their files: elbow by backlash (62 %), …": what stands first on page and terminal.
std::string robot_sentence(const RobotAnswer& robot);

/// "backlash (62 %), then delay (11 %)"; "no effect of the catalogue" where a gap has no cause in the catalogue.
std::string causes_words(const Diagnosis& d);

/// "gap", "no gap", "gap of unknown cause", "too little data", "units contradict each other", "refused", "not reached",
/// "interrupted".
std::string outcome_words(const JointOutcome& joint);

}  // namespace stickslip
