// What a controller adds to the sum of its gains: feed-forward, the push against dry friction, dither.
#pragma once
#include <cmath>
#include <numbers>

#include "analysis/base/field.h"

namespace stickslip {

/// What switches the push against dry friction.
enum class CoulombFrom {
    reference,  ///< the velocity that is commanded: silent at a set point, moves no root
    velocity,   ///< the velocity as the controller knows it: fed back
    error       ///< the side on which the set point lies: fed back
};
inline constexpr Choice<CoulombFrom> coulomb_sources[] = {
    {"reference", CoulombFrom::reference}, {"velocity", CoulombFrom::velocity}, {"error", CoulombFrom::error}};

/// What the controller adds for the commanded motion: acceleration · r̈ + the push against dry friction + the
/// effort that holds gravity at r. `velocity` is the share of ṙ in the velocity error velocity · ṙ − v. All of it but a
/// push that follows the motion itself depends on the reference r alone, so that it moves no root.
struct FeedForward {
    double velocity = 1, acceleration = 0, coulomb = 0, coulomb_speed = 1e-3, coulomb_width = 0;
    CoulombFrom coulomb_from = CoulombFrom::reference;
    bool gravity = false;

    /// Of ṙ: coulomb · tanh(ṙ/coulomb_speed). Of the measured v: the same of v, which gives more than dry friction
    /// takes where `coulomb` is more than the friction in motion. Of the error e outside the dead zone:
    /// coulomb · sat(e/coulomb_width)(1 − |tanh(v/coulomb_speed)|), a push towards the set point that fades once the
    /// joint moves.
    double push(double rate, double v, double e) const
    {
        if (coulomb == 0) return 0;
        if (coulomb_from == CoulombFrom::error) return coulomb * side(e) * fade(v, v < 0 ? -1 : 1).value;
        return coulomb * direction(coulomb_from == CoulombFrom::reference ? rate : v).value;
    }
    /// A share of the push and its slope by the velocity.
    struct Share {
        double value = 0, slope = 0;
    };
    /// tanh(v/coulomb_speed)
    Share direction(double v) const
    {
        const double share = std::tanh(v / coulomb_speed);
        return {share, (1 - share * share) / coulomb_speed};
    }
    /// 1 − |tanh(v/coulomb_speed)| of a motion forward (1) or backward (−1), so that it has a slope at rest.
    Share fade(double v, double forward) const
    {
        const Share share = direction(v);
        return {1 - forward * share.value, -forward * share.slope};
    }
    /// sat(e/coulomb_width), 0 at e = 0
    double side(double e) const
    {
        return e == 0 ? 0 : std::abs(e) < coulomb_width ? e / coulomb_width : std::copysign(1.0, e);
    }
    bool by_velocity() const { return coulomb != 0 && coulomb_from == CoulombFrom::velocity; }
    bool by_error() const { return coulomb != 0 && coulomb_from == CoulombFrom::error; }
    /// The push follows the motion, which closes a loop of its own.
    bool fed_back() const { return by_velocity() || by_error(); }
    /// The whole push on one side of the set point, its opposite on the other.
    bool jumps() const { return by_error() && coulomb_width == 0; }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"velocity", Quantity::number, any_finite, Need::optional,
                      "share of the reference velocity in the velocity error (with reference_velocity)"},
                     self.velocity);
        visit.number({"acceleration", Quantity::acceleration_gain, any_finite, Need::optional,
                      "effort per acceleration of the reference"},
                     self.acceleration);
        visit.number(Field{"coulomb", Quantity::command, any_finite, Need::optional,
                           "push against dry friction, in the direction that coulomb_from names"}
                         .called("F_{c}", "Coulomb friction"),
                     self.coulomb);
        visit.choice("coulomb_from",
                     "what switches that push: velocity of the reference, measured velocity, side of the position "
                     "error",
                     self.coulomb_from, coulomb_sources);
        visit.number({"coulomb_speed", Quantity::velocity, positive, Need::optional,
                      "velocity over which the push changes sign; with coulomb_from = \"error\" over which it fades"},
                     self.coulomb_speed);
        visit.number({"coulomb_width", Quantity::position, not_negative, Need::optional,
                      "coulomb_from = \"error\": position error over which the push rises, 0: at once"},
                     self.coulomb_width);
        visit.flag("gravity", "adds the effort that holds the documented gravity at the reference", self.gravity);
    }
};

/// amplitude · sin(frequency · t), added to the command all the time: it shakes the joint out of its static friction.
struct Dither {
    double amplitude = 0, frequency = 2 * std::numbers::pi * 100;

    double at(double t) const { return amplitude == 0 ? 0 : amplitude * std::sin(frequency * t); }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"amplitude", Quantity::command, not_negative, Need::optional,
                      "amplitude A of A sin(ω t) added to the command, 0 for none"},
                     self.amplitude);
        visit.number({"frequency", Quantity::angular_frequency, positive, Need::optional,
                      "angular frequency ω; of a sampled loop below half its sampling rate"},
                     self.frequency);
    }
};

}  // namespace stickslip
