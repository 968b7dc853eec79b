// Whether the controller of a joint is the sum of gains that gains_of makes of it.
#pragma once
#include "analysis/joint/gains.h"

namespace stickslip {

/// A velocity estimate that is filtered, averaged or apart from the readings does not sum to the position, so that the
/// integral of a cascade holds something else than that sum does.
inline bool is_sum_of_gains(const Control& control)
{
    if (control.structure == Structure::pid || velocity_integral_gain(control) == 0) return true;
    const auto& estimate = control.velocity_estimate;
    return estimate.tau == 0 &&
           (!is_set(control.period) || (estimate.form != EstimateForm::exact && estimate.average == 1));
}

}  // namespace stickslip
