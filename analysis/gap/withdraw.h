// A cause that makes unseen data worse is none, however well it fits.
#pragma once
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Where a named cause leaves a larger gap on held-out data than there was, the verdict becomes `unknown`, the reasons
/// say why, and nothing is left to confuse it with. The ranking stays. Whether it did so.
bool withdraw_if_worse(Diagnosis& diagnosis);

}  // namespace stickslip::gap
