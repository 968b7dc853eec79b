// What the audit of the controller has found, among the causes of the mechanism.
#pragma once
#include "analysis/diagnosis/verdict/judge_ladder.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Puts what the controller's regression is sure of, the first rung of the ladder, among the effects by itself: first,
/// unless causes in the mechanism are likely and take a good part beside it. Where those leave only noise, a small part
/// is no doubt about the controller, unless it is a number of the document that is further off than documents are.
/// Where the rest is numbers of the document, it is the only cause if both are right.
void put_controller_in_order(Cause controller, const JudgedLadder& judged, Diagnosis& diagnosis);

}  // namespace stickslip::gap
