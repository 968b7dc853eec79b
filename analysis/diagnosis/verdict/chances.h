// What decides how likely the causes of a ladder are. Internal to analysis/diagnosis/verdict.
#pragma once
#include "analysis/diagnosis/verdict/judge_ladder.h"

namespace stickslip::gap {

/// Whether the last rung is a small term that every machine has.
bool usual_of_machines(const Ladder& ladder);

/// A cause between the first rung and the last that is such a term, and takes as little beside the corrections and the
/// rungs above as would not be named if it were the last; null where there is none.
const Effect* small_term_between(const JudgedLadder& judged);

/// Whether the last rung is a number of the document that the rungs below hold at the bound of what a document is off.
/// Taken away, it would go back there, and bend the numbers of the causes that stay.
bool frees_held_number(const Ladder& ladder);

/// Whether every cause of a ladder is a number that the document states. It is further off than documents are, or it
/// would be a correction: however little the records feel it, the document is wrong.
bool only_stated_numbers(const Ladder& ladder);

}  // namespace stickslip::gap
