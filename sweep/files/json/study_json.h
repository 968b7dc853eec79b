// The linear study as `stickslip evaluate --json` prints it: documented, stable names.
#pragma once
#include "analysis/stability/study.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/study/root_locus.h"

#include <vector>

namespace stickslip {

/// {"response", "margins", "root_locus", "velocities", "comparison", "force_ramp", "reductions"}; what does not exist
/// or has no bound is null. docs/paper/experiments.md says where each answer is.
Json study_json(const LinearStudy& study, const std::vector<GainRoots>& locus);

}  // namespace stickslip
