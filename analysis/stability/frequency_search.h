// Searches along lines of the complex plane that miss nothing: every band of frequencies is either bounded away from a
// root or bisected. For joints with delays and tables, whose characteristic function is no polynomial.
#pragma once
#include <vector>

#include "analysis/stability/linear_joint.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// How much work the searches of this process may do, per the usual one: what they leave unsearched they say. To be set
/// before any search begins.
void set_search_effort(double times_usual);
double search_effort();

/// What a search along the imaginary axis found.
struct CrossingSearch {
    std::vector<Crossing> crossings;  ///< ascending in k_p, every one with 0 < k_p ≤ searched_to
    double searched_to = infinity;    ///< beyond this gain there may be more
    bool exhausted = false;           ///< given up before the requested gain
    std::vector<Interval> doubtful;   ///< bands of ω narrower than 1e-9 ω that bounds could not clear: a touch or a
                                      ///< double root may hide there
};

/// A frequency beyond which no root s = σ + iω of the joint exists for any gain 0 ≤ k_p ≤ `gain_limit`; in each row the
/// inertia then outweighs all else by more than 1/share (Gershgorin).
double frequency_bound(const LinearJoint& joint, double gain_limit, double sigma = 0, double share = 1);

/// Every solution of Im(a conj b) = 0 on the imaginary axis, the generalisation of (34), with 0 < k_p ≤ gain_limit
/// (35).
CrossingSearch search_crossings(const LinearJoint& joint, double gain_limit);

}  // namespace stickslip
