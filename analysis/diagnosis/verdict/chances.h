// What decides how likely the causes of a ladder are. Internal to analysis/diagnosis/verdict.
#pragma once
#include "analysis/diagnosis/verdict/judge_ladder.h"

namespace stickslip::gap {

/// Whether the last rung is a small term that every machine has.
bool usual_of_machines(const Ladder& ladder);

}  // namespace stickslip::gap
