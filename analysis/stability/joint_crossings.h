// Every gain at which roots of a joint cross the imaginary axis, and the stable set between them.
#pragma once
#include <vector>

#include "analysis/stability/characteristic.h"
#include "analysis/stability/frequency_search.h"

namespace stickslip {

/// All crossings of a rational joint with a gain > 0, ascending. With u = ω², Im(a conj b)/ω is a polynomial in u: its
/// roots separate the sign changes, each of which is then located on the characteristic function itself.
std::vector<Crossing> rational_crossings(const LinearJoint& joint, Gain gain);

/// All crossings in k_p: of a rational joint, complete; of one with delays or a table, complete up to searched_to,
/// which covers at least eight turns of the longest delay and four times the joint's own k_p.
CrossingSearch crossings(const LinearJoint& joint);

/// The open intervals of the gain, from 0 up to `searched_to`, in which the joint is stable, decided by is_stable
/// between neighbouring crossings, and among many by the roots that each crossing takes over the axis.
std::vector<Interval> stable_intervals(const LinearJoint& joint, const std::vector<Crossing>& crossings,
                                       double searched_to, Gain gain = Gain::k_p);

/// The k_v with which the velocity-only theory calls the joint stable at its k_p: with several bodies too much of it is
/// unstable, too.
std::vector<Interval> velocity_only_gains(const LinearJoint& joint);

}  // namespace stickslip
