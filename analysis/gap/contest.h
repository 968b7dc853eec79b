// When no cause brings the misfit down to the noise: which cause still predicts unseen data clearly best?
#pragma once
#include "analysis/gap/heldout.h"

namespace stickslip::gap {

/// One cause on top of the refitted joint.
struct Contestant {
    Candidate candidate;        ///< refitted numbers of the joint, then the cause
    Eigen::VectorXd x;          ///< fitted to all records, at the middle level
    double gain = 0;            ///< 1 − RMS with / RMS without the cause, on held-out data
    ConfidenceInterval spread;  ///< smallest and largest over the folds
};

/// A measured machine differs from any model in many small ways: its numbers are never quite the documented ones, and
/// something always remains. So the joint's own numbers (inertia, Coulomb and viscous friction, load) are refitted for
/// everybody, what they leave becomes the noise, and a cause has to earn its name by what it predicts beyond that on
/// data that its fit has not seen.
struct Contest {
    Contestant refitted;             ///< the joint's own numbers alone; its gain is over the documented joint
    std::vector<Contestant> ranked;  ///< best first
    bool decided = false;            ///< the first is worth its name and no other comes near
};

/// Largest gain of an also-ran, as a part of the winner's, at which the winner still stands alone.
inline constexpr double distinct = 0.5;
/// Least gain on held-out data that earns a name.
inline constexpr double worth_a_name = 0.1;

/// `singles` say which form of each cause is the best one. Two masses are tried only where a single of that kind was
/// among the first three: they cost ten times as much.
Contest hold_contest(const std::vector<Case>& cases, const Scales& scales, const std::vector<Attribution>& singles,
                     const ParallelFor& parallel);

}  // namespace stickslip::gap
