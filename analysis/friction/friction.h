// The friction on one body: a law, and the terms that a real joint may add to it. Every term is absent in a nominal
// joint.
#pragma once
#include <cmath>
#include <string>

#include "analysis/base/select.h"
#include "analysis/friction/law.h"

namespace stickslip {

/// Direction dependence, half the difference between the directions: f += coulomb + viscous |V|, the same sign both
/// ways.
struct Asymmetry {
    double coulomb = 0, viscous = 0;  ///< [N | N·m], [N·s/m | N·m·s/rad]

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"coulomb", Quantity::effort, any_finite, Need::optional,
                           "half the Coulomb difference between + and −"}
                         .called("F_{c}", "Coulomb friction"),
                     self.coulomb);
        visit.number(Field{"viscous", Quantity::damping, any_finite, Need::optional,
                           "half the viscous difference between + and −"}
                         .called("F_{v}", "viscous friction"),
                     self.viscous);
    }
};

/// Sines locked to position: amplitude · sin(n q + phase) + second_amplitude · sin(2 n q + second_phase), n = periods.
struct PositionRipple {
    double amplitude = 0, periods = 1, phase = 0;   ///< [N | N·m], n [1/m | 1/rad], rad
    double second_amplitude = 0, second_phase = 0;  ///< [N | N·m], rad

    /// Whether there is any ripple.
    bool acts() const { return amplitude != 0 || second_amplitude != 0; }
    double by_place(double q) const;  ///< slope over the position [N/m | N·m/rad]
    /// A bound of |by_place|.
    double steepest() const { return std::abs(amplitude * periods) + 2 * std::abs(second_amplitude * periods); }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"amplitude", Quantity::effort, any_finite, Need::optional, "amplitude of sin(n q + phase)"},
                     self.amplitude);
        visit.number(
            {"periods", Quantity::per_position, positive, Need::optional, "angular wave number n in sin(n q + phase)"},
            self.periods);
        visit.number({"phase", Quantity::angle, any_finite, Need::optional, "phase at q = 0"}, self.phase);
        visit.number({"second_amplitude", Quantity::effort, any_finite, Need::optional, "amplitude of sin(2 n q + …)"},
                     self.second_amplitude);
        visit.number({"second_phase", Quantity::angle, any_finite, Need::optional, "phase of the second harmonic"},
                     self.second_phase);
    }
};

/// The wave at this place, for one or for packs of them.
template <class Wave, class Real>
Real wave_at(const Wave& w, const Real& q)
{
    const Real angle = w.periods * q;
    Real sum = w.amplitude * sine(angle + w.phase);
    if (any(Real(w.second_amplitude) != Real(0.0)))
        sum = sum + w.second_amplitude * sine(Real(2.0) * angle + w.second_phase);
    return sum;
}

/// Warm-up: the Coulomb level changes by change · (1 − exp(−t / time_constant)), t from the start of the record.
struct FrictionDrift {
    double change = 0, time_constant = 10;  ///< [N | N·m], s

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"change", Quantity::effort, any_finite, Need::optional, "change of the Coulomb level"},
                     self.change);
        visit.number({"time_constant", Quantity::time, positive, Need::optional, "time constant of the change"},
                     self.time_constant);
    }
};

/// Friction of the gear of a joint that is one mass, per effort τ = G + beyond · J a that reaches the load side (G:
/// what the load resists): `forward` where the drive moves the load, `backward` where the load moves the drive. Their
/// efficiencies are 1/(1 + forward) and 1 − backward.
struct GearLoss {
    double forward = 0,
           backward = 0;  ///< friction per effort that reaches the load, driving and driven; below 1 driven
    double beyond = 1;    ///< part of the inertia on the load's side of the gear, within [0, 1]

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"forward", Quantity::number, not_negative, Need::optional,
                      "friction per effort that reaches the load, where the drive moves it"},
                     self.forward);
        visit.number(
            {"backward", Quantity::number, below_one, Need::optional, "the same where the load moves the drive"},
            self.backward);
        visit.number({"beyond", Quantity::number, part_of_one, Need::optional,
                      "part of the inertia that lies beyond the gear, on the side of the load"},
                     self.beyond);
    }

    /// Whether the gear has any friction.
    bool acts() const { return forward != 0 || backward != 0; }

    /// Friction where the load resists with `load` and everything but friction pushes with `net`, in motion along
    /// `direction` against other friction of this size. τ + direction · beyond · (that friction) = load + beyond · (net
    /// − direction · other), so that τ has the sign of the right side.
    template <class Real>
    static Real level(const Real& forward, const Real& backward, const Real& beyond, const Real& load, const Real& net,
                      const Real& direction, const Real& other)
    {
        using std::max;
        const Real one(1.0), along = direction * (load + beyond * (net - direction * other));
        return forward / (one + beyond * forward) * max(along, Real(0.0)) +
               backward / (one - beyond * backward) * max(-along, Real(0.0));
    }
};

/// Presliding under a static law: what the law resists apart from viscous friction is carried by bristles, in the form
/// of LuGre (bristle_response).
struct Bristle {
    double stiffness = 0, damping = 0;  ///< [N/m | N·m/rad], [N·s/m | N·m·s/rad]; stiffness 0: none

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"stiffness", Quantity::stiffness, not_negative, Need::optional, "bristle stiffness, 0 for none"},
                     self.stiffness);
        visit.number({"damping", Quantity::damping, not_negative, Need::optional, "bristle damping"}, self.damping);
    }
};

/// Memory on top of a law f: A asinh(V/(2V*) e^{(|f| + θ)/A}), away from rest f + (A ln(|V|/V*) + θ) sgn V, with one
/// state after the slip law, θ̇ = −(|V|/L)(θ + B ln(|V|/V*)), (5), or the ageing law. With A = 0: f + θ sgn V. And,
/// apart from it, a lag with which a static law's level, or all of it, follows the speed: g(s) in place of g(|V|), ṡ =
/// (|V| − s)/lag. The simulation of a record has the logarithmic form with |V| held above V*/1000, so that the joint
/// can stick.
struct Memory {
    double A = 0, B = 0, L = 1e-5, V_star = 1e-3;  ///< [N | N·m] twice, [m | rad], [m/s | rad/s]
    double lag = 0;                                ///< s
    bool lag_viscous = false;            ///< the lag holds for the viscous part, too: the whole curve follows late
    MemoryForm form = MemoryForm::slip;  ///< how the state evolves

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(
            Field{"A", Quantity::effort, not_negative, Need::optional, "direct velocity effect, 0 for none"}.called(
                "A", "direct effect"),
            self.A);
        visit.number(Field{"B", Quantity::effort, not_negative, Need::optional, "evolution effect, 0 for none"}.called(
                         "B", "evolution effect"),
                     self.B);
        visit.number(Field{"L", Quantity::position, positive, Need::optional, "characteristic slip distance"}.called(
                         "L", "slip distance"),
                     self.L);
        visit.number(Field{"V_star", Quantity::velocity, positive, Need::optional, "reference velocity V*"}.called(
                         "V*", "reference velocity"),
                     self.V_star);
        visit.number(Field{"lag", Quantity::time, not_negative, Need::optional,
                           "time lag of the velocity dependence, 0 for none"}
                         .called("τ", "time lag"),
                     self.lag);
        visit.flag("lag_viscous",
                   "the whole friction follows the speed late, viscous part included; else its level alone",
                   self.lag_viscous);
        visit.choice("form", "how the state evolves", self.form, memory_forms);
    }
};

/// The friction on one body.
struct Friction {
    FrictionLaw law;              ///< f(V, θ) before all that follows
    Asymmetry asymmetry;          ///< dependence on direction
    double normal_load = 1;       ///< σ_n of (1) per the one at which the numbers of the law hold: multiplies all of f
    double load_coefficient = 0;  ///< f += load_coefficient · |transmitted effort| · sgn V
    GearLoss gear;                ///< of a joint that is one mass, see OneMassFriction
    PositionRipple ripple;        ///< multiplies sgn V: flips with direction, unlike cogging
    FrictionDrift drift;          ///< warm-up of the Coulomb level, in time
    Bristle bristle;              ///< presliding stiffness under the law
    Memory memory;                ///< rate-and-state memory on top of the law

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.law(self.law);
        visit.table("asymmetry", "direction dependence", self.asymmetry);
        visit.number({"normal_load", Quantity::number, positive, Need::optional,
                      "normal load per the one at which the numbers of the law hold; multiplies the friction"},
                     self.normal_load);
        visit.number({"load_coefficient", Quantity::number, not_negative, Need::optional,
                      "friction per transmitted effort", Role::law},
                     self.load_coefficient);
        visit.table("ripple", "position dependence of the Coulomb level", self.ripple);
        visit.table("drift", "warm-up of the Coulomb level", self.drift);
        visit.table("bristle", "presliding stiffness under the law", self.bristle);
        visit.table("memory", "rate-and-state memory on top of the law", self.memory);
    }

    /// Whether its level changes with place, time or effort.
    bool level_moves() const { return load_coefficient != 0 || gear.acts() || ripple.acts() || drift.change != 0; }
    /// Whether presliding is modelled.
    bool has_bristle() const { return bristle.stiffness > 0; }
    /// Whether it has rate-and-state memory on top of the law.
    bool has_memory() const { return memory.A != 0 || memory.B != 0; }
    /// Whether friction follows the speed late.
    bool has_lag() const { return memory.lag > 0; }

    /// What ranges cannot say: bristles need a level that they carry, and the states must find room.
    std::string problem() const;
};

/// The friction of a joint that is one mass: with that of its gear, which a transmission has by `load_coefficient`.
struct OneMassFriction : Friction {
    OneMassFriction() = default;
    OneMassFriction(const Friction& friction) : Friction(friction) {}

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        Friction::fields(self, visit);
        visit.table("gear", "friction of a gear that grows with the effort at the load", self.gear);
    }
};

/// The friction of one body as one law: the calls of the concept (response.h) with every term included that depends on
/// neither position, time nor load. How many states it has: those of the law come first, then the lagged speed, then
/// the state of the bristles or of the memory, each where the body has it. None of these calls throws.
int states(const Friction& friction);
/// f_ss(V) [N | N·m], the friction of steady sliding at V [m/s | rad/s].
double steady_force(const Friction& friction, double V);
/// The states of steady sliding at V, each in the unit of its law.
States steady_state(const Friction& friction, double V);
/// Force, derivatives and rates of the states at this velocity and these states. Needs has_response().
FrictionResponse respond(const Friction& friction, double V, const States& theta);
/// Set-valued at rest: the largest force at V = 0 [N | N·m].
double static_force(const Friction& friction);

/// Bristles under a level that itself has a memory have coupled states, for which no response in this form exists.
bool has_response(const Friction& friction);

}  // namespace stickslip
