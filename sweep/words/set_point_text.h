// What a joint does at a set point, in words, for the terminal and the page.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/results/set_point.h"

#include <string>

namespace stickslip {

/// The answer in one sentence, in chart mark-up.
std::string set_point_text(const SetPoint& answer, Units units);

/// Every number of it with its unit.
Table set_point_table(const SetPoint& answer, Units units);

/// Why it hunts, rests or is undecided; "" for none.
std::string set_point_reason(SetPointReason reason);

/// The section of a page.
Section set_point_section(const SetPoint& answer, Units units);

}  // namespace stickslip
