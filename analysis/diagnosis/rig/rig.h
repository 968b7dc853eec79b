// A friction rig: a load point moves as commanded, a spring pulls the slider, and only the force is measured.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/diagnosis/verdict/result.h"

namespace stickslip::gap {

/// A record with one displacement, that of the load point, and the friction, but neither command nor drive.
bool is_rig(const Record& record);

/// Which law lets a massless slider behind a spring (fitted) answer the load point with the measured friction: a level,
/// a curve of the velocity, a drift, or memory by the slip law, the ageing law, or in time. Levels are refitted for
/// everybody. One law for all records and both directions, see rig_of(); blocks of rows are held out in turn. Records
/// of under 100 rows are left out, and the reasons say so.
DiagnosisResult diagnose_rig(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel);

}  // namespace stickslip::gap
