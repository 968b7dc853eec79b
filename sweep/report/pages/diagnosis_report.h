// The report of a diagnosis: where, what, how much, how sure, and what to measure next.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"
#include "sweep/study/corrected_gains.h"
#include "sweep/study/stable_windows.h"

namespace stickslip {

/// Composes the page. `before` and `after` are the nominal joint and the one with the named effects, `moved` the
/// boundary of both and `gains` what it means for them, where a cause is named; `snippets` are what to take from it
/// into files. `rig`: a friction rig, which has no controller and whose friction is in the unit of its record.
Report diagnosis_report(const Diagnosis& diagnosis, const Joint& before, const Joint& after, const MovedBoundary& moved,
                        const CorrectedGains& gains, std::vector<std::pair<std::string, std::string>> provenance,
                        std::vector<Snippet> snippets = {}, bool rig = false);

}  // namespace stickslip
