// What a simulator that has only the exported numbers leaves of the gap.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/diagnosis/records/record.h"
#include "sweep/study/export/export.h"

#include <vector>

namespace stickslip {

/// Runs of the joint, and of what the text holds of it, along every record, without noise, against what was logged
/// there. ros2_control drives the machine itself: there the joint runs under the gains alone. Throws
/// std::invalid_argument for joints without a record simulation and for records without a reference.
GapLeft gap_left(const Joint& joint, Simulator to, const ExportOptions& options, const std::vector<Record>& records,
                 const ParallelFor& parallel);

}  // namespace stickslip
