// The diagnosis of one joint: where the gap lies, what causes it, how far it shrinks, how sure that is.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/diagnosis/verdict/result.h"
#include "analysis/results/diagnosis_stage.h"

#include <exception>
#include <string>
#include <vector>

namespace stickslip::gap {

/// Thrown by tasks that are to stop; diagnose() then gives back what it has found.
struct Interrupted : std::exception {};

/// How much a diagnosis computes, and who hears of its progress.
struct DiagnosisOptions {
    std::size_t pair_partners = 3;  ///< how many of the best singles look for a partner
    int ensemble = 10;              ///< noisy runs behind before, after and floor
    StageProgress progress = {};    ///< called from the calling thread only

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// Diagnoses records of one joint. Analysis owns no threads: `parallel` runs tasks, each writes its own slot, so the
/// answer does not depend on how many run at once. It may throw Interrupted to end early. Throws std::invalid_argument
/// for records that cannot be read as time series (see inspect), for joints without a record simulation and for options
/// with a problem().
DiagnosisResult diagnose(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel,
                         const DiagnosisOptions& options = {});

}  // namespace stickslip::gap
