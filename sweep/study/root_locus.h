// The roots of a joint over its position gain, sampled so finely that no visible branch shows corners.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"

#include <complex>
#include <optional>
#include <vector>

namespace stickslip {

struct RootLocus {
    std::vector<double> gains;                             ///< k_p, ascending
    std::vector<std::vector<std::complex<double>>> roots;  ///< one row a gain; column n is one branch
    double own_gain = 0;                                   ///< the joint's k_p
    std::vector<std::complex<double>> own;                 ///< its roots
    double limit = 0;                                      ///< |s| of what is worth drawing
    bool rational = true;                  ///< false: roots have no end, those furthest to the right are here
    std::vector<BoundaryPoint> crossings;  ///< k_p at which stability changes
};

/// Nothing without steady sliding forwards, or where no root moves within the limit.
std::optional<RootLocus> sampled_root_locus(const Joint& joint, double lowest_gain, double highest_gain);

/// Roots at one gain.
struct GainRoots {
    double k_p;
    std::vector<std::complex<double>> roots;
};

/// For numbers, not for a drawing: two decades to either side of the joint's own gain, in a dozen steps a decade, in
/// two where roots have no end. Empty where no root is known. The joint slides steadily.
std::vector<GainRoots> coarse_root_locus(const Joint& joint);

}  // namespace stickslip
