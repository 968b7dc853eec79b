// The report of a diagnosis: where, what, how much, how sure, and what to measure next.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

namespace stickslip {

/// Composes the page. `before` and `after` are the nominal joint and the one with the named effects.
Report diagnosis_report(const Diagnosis& diagnosis, const Joint& before, const Joint& after,
                        std::vector<std::pair<std::string, std::string>> provenance);

/// The answer in one sentence.
std::string diagnosis_sentence(const Diagnosis& diagnosis);

}  // namespace stickslip
