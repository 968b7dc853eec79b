// How good a reduction is: the boundary of the full joint and of the reduced one, side by side.
#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "analysis/joint/reduction.h"
#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// The boundary along one parameter of the full joint, and where its reduction puts it.
struct ReductionError {
    std::vector<double> full, reduced;  ///< values of the parameter at which stability changes, ascending
    /// Largest relative distance between boundaries that correspond; infinity where their number differs, NaN where
    /// neither joint has one: nothing was compared.
    double error = missing;
};

/// The reduced joint about steady sliding at V, with every friction that it carries.
LinearJoint linear_joint(const Reduction& reduced, double V);

/// max Re s of the reduced joint with memory at its commanded velocity; NaN where there is no verdict.
double growth_rate(const Reduction& reduced);

/// Moves the parameter at `path` of the *full* joint over [low, high] (logarithmic scan, then bisection to 1e-10; for
/// k_p of the loop the crossings themselves); the
/// reduction is done anew for each value, so both joints mean the same machine. Both verdicts are those of friction
/// with memory. Throws std::invalid_argument if there is no such parameter or the reduction refuses the joint.
ReductionError compare_reduction(const Joint& full, const std::function<Reduction(const Joint&)>& reduce,
                                 std::string_view path, double low, double high, int scan = 120);

}  // namespace stickslip
