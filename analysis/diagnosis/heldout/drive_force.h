// How far the drive force that a model asks for is from the one that was applied, on data that the fit has not seen.
#pragma once
#include "analysis/diagnosis/heldout/heldout.h"

namespace stickslip::gap {

/// The force that a joint lacks along a record, one entry a row and NaN at the ends: an observer that follows the
/// record has to add it to the model. With e the reading minus the prediction, T the time between rows, g and k the
/// gains of the observer (see predict), the missing force, averaged over two rows, is exactly
///   J ([e_{n+1} − (2 − g) e_n + (1 − g) e_{n−1}] / T² + k e_n / T).
/// It is then low-passed without phase: a Butterworth of fourth order, forth and back. Rows must be equally spaced.
std::vector<double> missing_force(const Case& c, const Joint& joint, double corner);

/// 100 Hz, or a tenth of the sampling rate where that is less; 0 where rows are not equally spaced.
double drive_force_corner(const std::vector<Case>& cases);

/// The RMS of what is left of the missing force on held-out data, and the gain over the first model, over the folds.
struct DriveForce {
    double rms = 0, gain = 0;
    ConfidenceInterval spread;
};

/// A stiff loop hides every model error in the position; what is wrong shows in the force that drives the joint. Refits
/// each model without each fold, from the numbers that it has, and compares what they leave there with what the first
/// one leaves.
std::vector<DriveForce> hold_out_drive_force(const Fit& fit, const std::vector<const Attribution*>& models);

}  // namespace stickslip::gap
