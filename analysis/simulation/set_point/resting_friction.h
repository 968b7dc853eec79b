// The dry friction that holds a joint at a set point.
#pragma once
#include "analysis/friction/friction.h"
#include "analysis/results/set_point.h"
#include "analysis/simulation/set_point/slip.h"

namespace stickslip {

/// Coulomb, static and viscous friction of a law that has them; the law's forces are multiplied by the normal load.
struct RestingFriction {
    DryFriction dry;
    double viscous = 0;
    double presliding = 0;  ///< how far bristles give way up to F_s; 0: true rest
    bool flat = false;      ///< F_c at every speed: closed form
};

struct FrictionOrReason {
    RestingFriction friction;
    SetPointReason reason = SetPointReason::none;
};

/// `reason`: why a friction has no such levels.
FrictionOrReason resting_friction(const Friction& friction);

}  // namespace stickslip
