// What looks wrong about a record that reads well: units, gaps, a motor that was off. Internal to sweep/files.
#pragma once
#include "analysis/gap/record.h"
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip::files {

/// One sentence each. Suspicions of units compare signals with one another and with the joint; they never change data.
std::vector<std::string> suspicions(const Record& record, const Joint& joint);

}  // namespace stickslip::files
