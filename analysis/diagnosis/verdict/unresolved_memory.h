// Frictional memory that no encoder of the records resolves.
#pragma once
#include "analysis/diagnosis/fit/effect.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/results/diagnosis.h"

#include <span>

namespace stickslip::gap {

/// A memory of a slip length within a few of the smallest readings has passed before a record shows it: what is left of
/// it is a curve of friction over velocity, which Stribeck friction of another shape is as well. Where it is named,
/// that is a cause as likely as it, with the same others beside it.
void doubt_unresolved_memory(std::span<const Case> cases, const Scales& scales, Diagnosis& diagnosis);

}  // namespace stickslip::gap
