// Which points of a chart are stable in every joint of an uncertainty, which in the joint as described alone.
#pragma once
#include "sweep/study/margins_answer.h"

namespace stickslip {

/// Between the followed edges of `answer.robust` and `answer.nominal`, which it needs: one verdict of each a row tells
/// on which side the row begins, and the curves where it changes.
RobustSet robust_set(const MarginsAnswer& answer);

}  // namespace stickslip
