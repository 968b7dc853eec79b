// diagnosis.json: documented, stable names (a diagnosis as data).
#pragma once
#include "analysis/results/diagnosis.h"
#include "sweep/study/stable_windows.h"

#include <nlohmann/json.hpp>

namespace stickslip {

/// The stability boundary of one joint as the diagnosis reports it; a reason where the linear theory has no answer.
nlohmann::ordered_json windows_json(const StableWindows& windows);

/// Every field of a diagnosis. `windows` are those of the joint as documented and of the one with the named effects;
/// equal where nothing was named. Throws std::logic_error for a verdict `gap` whose cause leaves more than there was:
/// see reject_if_not_validated.
nlohmann::ordered_json diagnosis_json(const Diagnosis& diagnosis, const WindowsOfBoth& windows);

}  // namespace stickslip
