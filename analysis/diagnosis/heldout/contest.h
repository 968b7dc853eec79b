// When no cause brings the misfit down to the noise: which one still predicts unseen data clearly best?
#pragma once
#include "analysis/diagnosis/heldout/heldout.h"

namespace stickslip::gap {

/// A cause on top of the joint's refitted own numbers.
struct Contestant {
    Attribution fit;            ///< all effects together; the own numbers come first. Fitted at the middle level
    double gain = 0;            ///< 1 − RMS with / RMS without the cause, on held-out data
    ConfidenceInterval spread;  ///< smallest and largest over the folds
    std::vector<double> squares;
    double force_gain = not_set;  ///< the same for the drive force: see drive_force.h
    ConfidenceInterval force_spread;
    double force_rms = 0;  ///< of the drive force that is left on held-out data, N | N·m
};

/// A measured machine differs from any model in many small ways: its numbers are never quite the documented ones, and
/// something always remains. So the joint's own numbers (inertia, Coulomb and viscous friction, load) are refitted for
/// everybody, what they leave becomes the noise, and a cause has to earn its name by what it predicts beyond that on
/// data that its fit has not seen: a quarter of the RMS, and a part of it in every fold.
struct Contest {
    std::size_t own_numbers = 0;     ///< effects at the head of every contestant that are refitted numbers
    Attribution base;                ///< the refitted numbers alone
    ConfidenceInterval refit;        ///< gain of the own numbers alone over the documented joint, over the folds
    std::vector<Contestant> ranked;  ///< best first
    bool decided = false;            ///< the first is worth its name
    std::vector<const Contestant*> ambiguous;  ///< what the first does not clearly beat in every fold
};

/// What a fit at `level` leaves in each record becomes the noise: no record drowns the others.
void raise_floor(std::vector<Case>& cases, const Evaluation& now);

/// Mean square of the scaled residuals inside one fold.
double square_in(const Case& c, const Fold& fold, const Scales& scales, const Candidate& candidate,
                 const Eigen::VectorXd& x, double omega);

/// Smallest and largest gain in RMS over the folds.
ConfidenceInterval spread_of(const std::vector<double>& before, const std::vector<double>& after);

/// `singles` are the causes to try, each in its best form and from where its fit came to, best first. Those that gain
/// most at a first look go on to the folds.
Contest hold_contest(const std::vector<Case>& cases, const Scales& scales, const std::vector<Attribution>& singles,
                     const ParallelFor& parallel);

}  // namespace stickslip::gap
