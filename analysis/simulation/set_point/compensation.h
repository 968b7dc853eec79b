// What a controller may add against dry friction at a set point.
#pragma once

namespace stickslip {

/// What a controller adds against dry friction while its reference stands still; control.feed_forward, which looks at
/// the reference's velocity, is silent then. Of the measured velocity v: level · tanh(v/speed). Of the error e outside
/// the dead zone: level · sat(e/width)(1 − |tanh(v/speed)|), a push towards the set point that fades once the joint
/// moves, as in the arm of examples/08-hunting-arm.
struct Compensation {
    enum class From { nothing, velocity, error };
    From from = From::nothing;
    double level = 0;  ///< in the units of the command
    double speed = 1e-3, width = 0;

    bool by_velocity() const { return from == From::velocity && level != 0; }
    bool by_error() const { return from == From::error && level != 0; }
    bool acts() const { return by_velocity() || by_error(); }
    /// The whole level on one side of the set point, its opposite on the other.
    bool jumps() const { return by_error() && width == 0; }
};

}  // namespace stickslip
