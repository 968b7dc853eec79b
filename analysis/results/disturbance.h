// What disturbs steady sliding.
#pragma once
#include "analysis/results/point.h"

namespace stickslip {

/// What a disturbance changes of steady sliding. `position` and `velocity` keep the balance of forces by the state
/// where the law has one: a change of V alone dies in the fast inertial mode at small V_0 and shows nothing of the slow
/// one.
enum class DisturbanceKind {
    position,  ///< an offset of position [m], forces balanced
    velocity,  ///< an offset of velocity [m/s], forces balanced
    impulse,   ///< a step of velocity alone, m δV = the impulse [N·s]
    offset,    ///< an offset of position alone [m]: a step of the commanded position
    state,     ///< an offset of the friction force by the states of the law alone [N]
    start      ///< steady sliding at a share [1] of V_0, from which V_0 is commanded; 0: from rest
};

/// A disturbance of steady sliding: of which kind, and how large.
struct Disturbance {
    DisturbanceKind kind = DisturbanceKind::position;  ///< what is offset
    double size =
        missing;  ///< in the unit of its kind; not set: small_disturbance · V_0/|s|, the slow mode at that share of V_0
};

/// Share of V_0 that a disturbance of unset size changes the velocity by.
inline constexpr double small_disturbance = 1e-6;

}  // namespace stickslip
