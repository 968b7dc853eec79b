// diagnosis.json: documented, stable names (a diagnosis as data).
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"

#include <nlohmann/json.hpp>

namespace stickslip {

/// The stability boundary of one joint as the diagnosis reports it; null where the linear theory has no answer.
nlohmann::ordered_json boundary_json(const Joint& joint, double speed);

/// Every field of a diagnosis. `before` and `after` are joints for the boundary; equal where nothing was named.
/// Throws std::logic_error for a verdict `gap` whose cause leaves more than there was: see reject_if_not_validated.
nlohmann::ordered_json diagnosis_json(const Diagnosis& diagnosis, const Joint& before, const Joint& after);

}  // namespace stickslip
