// What a control engineer asks of a linear joint: answer to disturbances, margins, root locus.
#pragma once
#include <complex>
#include <functional>
#include <vector>

#include "analysis/stability/linear_joint.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// X/D(s): the link's position per disturbance on the link; for one mass 1/(m s² + (k_v + f_v − G(s)) s + k_p),
/// (19), G the Laplace transform of friction's kernel; position per effort [m/N | rad/(N·m)].
std::complex<double> disturbance_response(const LinearJoint& joint, std::complex<double> s);

/// The largest |X/D|(iω) and its frequency; `magnitude` is infinite at a boundary and NaN for an unstable joint, whose
/// answer to a steady sine does not exist.
struct ResponsePeak {
    double omega, magnitude;  ///< rad/s; position per effort [m/N | rad/(N·m)]
};

/// A scan of `points` frequencies around the roots of the joint, each local maximum then refined: a peak narrower than
/// a step of the scan and away from every root can be missed.
ResponsePeak response_peak(const LinearJoint& joint, int points = 400);
/// The same of any loop: |X/D| over ω, its roots, and the frequency up to which it is known.
ResponsePeak response_peak(const std::function<double(double)>& size, const std::vector<std::complex<double>>& roots,
                           int points, double highest);

/// How far the loop is from its boundary. Factors that apply to k_p alone; 0 and infinity where no boundary is met.
struct LoopMargins {
    double gain_below;  ///< k_p may shrink to this part of itself
    double gain_above;  ///< k_p may grow by this factor
    double phase;       ///< rad: least extra lag at a crossover |L(iω)| = 1 that makes the joint unstable
    double crossover;   ///< rad/s, where that happens; NaN: |L| nowhere 1
};

/// L(s) = (k_p + k_v s) b/a opened at the controller. For a stable joint; all NaN otherwise.
/// `crossings`: those of the joint in k_p (stable_gains).
LoopMargins loop_margins(const LinearJoint& joint, const std::vector<Crossing>& crossings, int points = 2000);
/// With the crossings of this linear joint, its steady sliding held.
LoopMargins loop_margins(const LinearJoint& joint, int points = 2000);

/// The roots for each k_p of the list, row by row; column i follows one root from gain to gain (nearest neighbours).
std::vector<std::vector<std::complex<double>>> root_locus(LinearJoint joint, const std::vector<double>& gains);

/// Orders each row so that column i goes on with the root that is nearest to its last one.
void follow_branches(std::vector<std::vector<std::complex<double>>>& rows);

}  // namespace stickslip
