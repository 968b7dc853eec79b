// Where folds of limit cycles are begun. Internal to analysis/boundary.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/kinds/orbit_system.h"

#include <optional>
#include <vector>

namespace stickslip {

/// Per scale, the size of an orbit below which a branch has come to its end: at a Hopf point, which on an axis that is
/// wide beside the strip of the branch solves the equations of a fold, too.
inline constexpr double least_orbit = 0.01;

/// A fold to be polished: states on the section and the share of the axis.
struct FoldSeed {
    Eigen::VectorXd w;
    double q = 0;
};

/// Whether small cycles exist on the stable side of a joint that stands on its linear boundary.
bool is_subcritical(const Joint& on_boundary);

/// The fold that the branch of small cycles from a linear boundary leads to, along an axis.
std::optional<FoldSeed> fold_beyond_hopf(const OrbitSystem& one_parameter, double q);

/// The fold towards which the cycle leads that a start from near rest reaches; `towards` is ±1 along the axis.
std::optional<FoldSeed> fold_beyond_cycle(const OrbitSystem& one_parameter, double q, int towards);

/// The weights of a walk among orbits with the given number of parameters.
Eigen::VectorXd orbit_weight(const Eigen::VectorXd& z, int parameters);

}  // namespace stickslip
