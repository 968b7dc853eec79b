// A set of causes with its promise, and why there is none, in words.
#pragma once
#include "analysis/results/cause_set.h"
#include "sweep/study/guarantee/calibration.h"

#include <string>
#include <vector>

namespace stickslip {

/// "The cause is backlash or compliance: right in at least 95 of 100 such joints."
std::string cause_set_text(const CauseSet& set);

/// "backlash or compliance"; what stays possible.
std::string possible_text(const CauseSet& set);

/// A share as a number of hundred: "95".
std::string of_hundred(double share);

/// What the promise rests on, and what it does not cover.
std::string promise_text(const CauseSet& set);

/// Why this joint gets no promise from the calibration; one sentence each.
std::string stranger_text(const guarantee::Stranger& stranger);

/// Why a calibration promises nothing: too few cases.
std::string too_few_cases_text(const guarantee::Promise& promise);

}  // namespace stickslip
