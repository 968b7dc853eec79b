// What a joint does when its loop is to hold a set point: V_0 = 0.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/set_point.h"

#include <string>

namespace stickslip {

/// Whether the loop integrates, so that a set point is a question of its own.
bool integrates(const Joint& joint);

/// How a set point is examined.
struct SetPointQuestion {
    int starts_per_decade = 8;  ///< how densely the starts of slips are looked at where there is no closed form
    bool by_start = true;  ///< follow starts to their ends: SetPoint::by_start, and what an unstable loop does nearby

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// Without what starts come to: where it hunts, rests or diverges in the same places at less work.
inline constexpr SetPointQuestion quick_set_point{8, false};

/// Hunting at a set point: in closed form for Coulomb friction with a static level under nothing but gains; by events
/// for a falling curve, a dead zone and limits; by following the motion for bristles (LuGre, Dahl); tick by tick in its
/// own loop for a joint that is sampled, late, filtered, or pulled by what changes over its positions. `yes`: a cycle
/// of stops and slips exists that attracts its neighbours. A loop that is unstable while it moves diverges from far
/// away, whatever friction does about it; what it does from nearby is looked for. Laws that creep at rest, delayed and
/// linear ones, joints of several bodies and force loops are undecided, with the reason. A push of control.feed_forward
/// that looks at the reference is silent at a set point, one that follows velocity or error acts. A dither of amplitude
/// D below the kinetic friction F_c lets no motion last in a loop that does not integrate: d/dt(m v²/2 + k_p x²/2) <=
/// −(F_c − D)|v|. It rests where F_s − D holds it. Throws std::invalid_argument for a question with a problem().
SetPoint set_point(const Joint& joint, const SetPointQuestion& question = {});

}  // namespace stickslip
