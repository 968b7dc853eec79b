// Unmodelled forces: what shape-free functions of position or velocity alone can explain, or of a follower that the
// position drags along (the play operator of hysteresis: Visintin 1994), or an inertia that changes in the course of
// every record (a load that is picked up or runs out). They belong to no effect of the catalogue, and to no joint file:
// where one explains the records clearly better than any cause, the cause is only the nearest in shape, and is not
// named.
#pragma once
#include "analysis/diagnosis/fit/corrections.h"
#include "analysis/diagnosis/search/attribute.h"

#include <string_view>

namespace stickslip::gap {

struct FreeFit {
    std::string_view of;  ///< "position" | "velocity" | "hysteresis" | "inertia"
    Attribution fit;
    /// What it gains of the mean log misfit where it follows no more than the error of a known load. A computed load
    /// is wrong where another joint turns round, again and again at the same positions of this one.
    double by_load_error = 0;
};

/// One fit of each of the shapes, at all bandwidths, with corrections of the joint's own parameters where they are
/// given; the best one first.
std::vector<FreeFit> fit_free_forces(const Fit& fit, const Corrections* corrections = nullptr);

/// Whether a shape-free force leaves clearly less of the misfit than a cause does. Its many parameters cost nothing
/// here: on tens of thousands of rows they fit next to no noise.
bool clearly_better(const FreeFit& free, const Attribution& cause);
/// Less than what a cause leaves of the mean log misfit.
bool clearly_better(const FreeFit& free, double left);

}  // namespace stickslip::gap
