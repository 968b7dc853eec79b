// The [load] table: what acts on the link from outside.
#pragma once
#include "analysis/base/field.h"
#include "analysis/friction/friction.h"

namespace stickslip {

/// A force in time: amplitude · sin(frequency · t + phase), not locked to position.
struct PeriodicForce {
    double amplitude = 0, frequency = 1, phase = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"amplitude", Quantity::effort, any_finite, Need::optional, "amplitude A of A sin(ω t + phase)"},
                     self.amplitude);
        visit.number({"frequency", Quantity::angular_frequency, positive, Need::optional, "angular frequency ω"},
                     self.frequency);
        visit.number({"phase", Quantity::angle, any_finite, Need::optional, "phase at t = 0"}, self.phase);
    }
};

/// What acts on the link from outside, positive in the direction of positive motion.
struct Load {
    double constant = 0;
    double gravity_amplitude = 0, gravity_phase = 0;  ///< force −amplitude · sin(q + phase)
    PositionRipple cogging;                           ///< position-locked, does not flip with direction
    PeriodicForce disturbance;                        ///< time-locked

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"constant", Quantity::effort, any_finite, Need::optional, "constant load"}.called(
                         "F_{load}", "constant load"),
                     self.constant);
        visit.number(
            Field{"gravity_amplitude", Quantity::effort, any_finite, Need::optional, "m g l of a pendulum load"}.called(
                "m g l", "gravity amplitude"),
            self.gravity_amplitude);
        visit.number({"gravity_phase", Quantity::angle, any_finite, Need::optional,
                      "phase of gravity, −amplitude · sin(q + phase)"},
                     self.gravity_phase);
        visit.table("cogging", "position-locked force", self.cogging);
        visit.table("disturbance", "time-locked force", self.disturbance);
    }
};

}  // namespace stickslip
