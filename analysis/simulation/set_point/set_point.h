// What a joint does when its loop is to hold a set point: V_0 = 0.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/set_point.h"
#include "analysis/simulation/set_point/compensation.h"

namespace stickslip {

/// Whether the loop integrates, so that a set point is a question of its own.
bool integrates(const Joint& joint);

struct SetPointQuestion {
    Compensation compensation;  ///< beside the joint's own controller
    int starts_per_decade = 8;  ///< how densely the starts of slips are looked at where there is no closed form
};

/// Hunting at a set point: in closed form for Coulomb friction with a static level under nothing but gains; by events
/// for a falling curve, a dead zone and limits; by following the motion for bristles (LuGre, Dahl). `yes`: a cycle of
/// stops and slips exists that attracts its neighbours. Laws that creep at rest, delayed and linear ones, joints of
/// several bodies and force loops are undecided, with the reason. control.feed_forward looks at the reference and is
/// silent at a set point.
SetPoint set_point(const Joint& joint, const SetPointQuestion& question = {});

}  // namespace stickslip
