// The card of a set of causes with a promise.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

#include <vector>

namespace stickslip {

/// What stays possible, and how often such a set is right; none where no guarantee was requested.
std::vector<Headline> guarantee_card(const Diagnosis& d);

}  // namespace stickslip
