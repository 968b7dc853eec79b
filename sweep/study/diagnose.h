// The answer of `diagnose` for one joint: its records against its description, as records are simulated.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"
#include "analysis/results/diagnosis_stage.h"
#include "sweep/study/stable_windows.h"

#include <vector>

namespace stickslip {

struct JointDiagnosis {
    Diagnosis diagnosis;
    Joint before, after;
    WindowsOfBoth windows;      ///< stable gains of both
    bool contradicted = false;  ///< records and joint are in different units: nothing was concluded
    bool rig = false;           ///< a friction rig, which has no controller
};

/// Throws std::invalid_argument for records that are no time series, and for joints that no record is simulated with.
/// `parallel` may throw gap::Interrupted to end early. Where `contradictions` are known already nothing is computed:
/// a cause fitted to records in another unit would be named with confidence, and wrong.
JointDiagnosis diagnose_records(const Joint& documented, const std::vector<Record>& records,
                                const std::vector<Note>& contradictions, const ParallelFor& parallel,
                                const StageProgress& progress = {});

/// The same without its windows, of records that were made for this joint.
Diagnosis diagnose_made_records(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel);

}  // namespace stickslip
