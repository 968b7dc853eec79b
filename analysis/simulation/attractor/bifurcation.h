// Where limit cycles come from and where they end: the Hopf point at the critical gain, its criticality, and the fold
// at which the cycles that reach beyond it vanish.
#pragma once
#include <optional>

#include "analysis/simulation/attractor/cycle.h"

namespace stickslip {

/// The Hopf point of a flow at its critical gain. Near it an amplitude r of ln V (of V/V_0 for laws that may rest)
/// obeys ṙ = σ(k_p) r + lyapunov · r³: negative is supercritical, cycles are born where steady sliding is unstable.
struct HopfPoint {
    double k_p = missing;       ///< critical gain k_cr [N/m | N·m/rad]
    double omega = missing;     ///< rad/s, of the small orbit
    double lyapunov = missing;  ///< Re c_1 for that scaling of the critical eigenvector [1/s]
    FlowVector direction;       ///< y − y_ss at the largest position of a small orbit, per unit of position
};

/// First Lyapunov coefficient by projection on the critical eigenvectors. Source: Yu. A. Kuznetsov, Elements of Applied
/// Bifurcation Theory, (5.34); second and third derivatives are differences of the exact Jacobian.
/// `flow` has k_p at its critical gain, so that its slowest pair of eigenvalues is imaginary.
HopfPoint hopf_point(const Flow& flow);

/// A limit cycle of given amplitude and the gain that it needs: amplitude, unlike the gain, does not turn back at a
/// fold.
struct BranchPoint {
    double k_p = missing;  ///< gain with which the cycle exists [N/m | N·m/rad]
    FlowVector start;      ///< on the section, at the largest position
};

/// The cycle whose largest position is start[0], by Newton in the states and the gain from the guess given.
std::optional<BranchPoint> cycle_of_amplitude(const Flow& flow, const BranchPoint& guess, const CycleOptions& options);

/// The cycle at the highest gain at which it can still be found from the one before: steps in the gain, which do not
/// mind where the amplitude turns back. The fold itself lies just above.
BranchPoint last_at_rising_gain(const Flow& flow, BranchPoint on_branch, const CycleOptions& options);

/// Follows the branch of cycles from a point on it towards rising gain until the gain turns back: the fold, above which
/// these cycles are gone. Nothing if the gain never rises, or the branch is lost.
std::optional<BranchPoint> fold_of_cycles(const Flow& flow, const BranchPoint& on_branch, const CycleOptions& options);

/// The fold that a subcritical Hopf point leads to.
std::optional<BranchPoint> fold_of_cycles(const Flow& flow, const HopfPoint& hopf, const CycleOptions& options);

}  // namespace stickslip
