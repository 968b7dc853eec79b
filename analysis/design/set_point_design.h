// A set point held without hunting: over the integral gain, the dead zone and a push against
// dry friction.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/joint/joint.h"
#include "analysis/results/set_point_design.h"

namespace stickslip {

struct SetPointRequirements {
    double friction_margin = 0.1;  ///< static and kinetic friction, each by this share more or less
    double push_speed = not_set;   ///< over which a push fades; not set: control.feed_forward.coulomb_speed
    double k_i = not_set;          ///< of the ways that integrate; not set: the joint's, or a tenth of Routh's limit
    bool over_k_i = true, over_dead_zone = true, over_push = true, over_dither = true;
    int starts_per_decade = 32;  ///< of slips in a proof
};

/// Every way in turn, each with its numbers such that the joint hunts with none of the frictions:
///  - a push S from the error's side: a slip from −a → 0 meets F_s − F_c up to the set point and F_s − F_c − 2S behind
///    it, so that it ends at a (F_s − F_c)/(2S − F_s + F_c), nearer than it began iff S > F_s − F_c; S < F_s, or the
///    push alone moves the joint. S is the geometric mean of the ends of that window over all frictions;
///  - a dither below the least kinetic friction, without an integral: set_point.h says why all motion dies;
///  - a dead zone: the least at which no cycle exists, by bisection of the event-driven answer, a tenth wider.
/// Proofs are those of set_point, for the four corners of friction. Throws std::invalid_argument for joints that have
/// no such question: several bodies, force control, a cascade, laws without a static level.
SetPointDesign design_set_point(const Joint& joint, const SetPointRequirements& requirements,
                                const ParallelFor& parallel);

/// The joint with the numbers of a choice.
Joint with_choice(Joint joint, const SetPointChoice& choice);

}  // namespace stickslip
