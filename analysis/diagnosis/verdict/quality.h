// How well the records determine the numbers of a cause, and whether its pattern is there.
#pragma once
#include "analysis/diagnosis/heldout/ensemble.h"

namespace stickslip::gap {

struct Quality {
    Eigen::MatrixXd covariance;          ///< of the parameters in the units in which they are fitted; empty: unknown
    std::vector<double> standard_error;  ///< SI; NaN where the records leave a parameter open
    bool plausible = true;
    bool signature = false;
};

/// Whether no parameter stands at its bound, or is far larger than usual.
bool plausible_numbers(const Attribution& a);

/// Standard errors from the information at the middle level; plausible: no parameter at its bound or ten times what is
/// usual; signature: the pattern that the effect predicts is found wherever it should act.
Quality quality_of(const std::vector<Case>& cases, const Attribution& a, const Scales& scales);

}  // namespace stickslip::gap
