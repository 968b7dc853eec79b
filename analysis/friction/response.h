// The concept that all friction laws share. A law is a plain struct of named parameters with
//
//   static constexpr LawInfo info;
//   int states() const;                                    how many internal states θ_i it has
//   double steady_force(double V) const;                   f_ss(V), the friction-velocity curve of steady sliding
//   States steady_state(double V) const;                   the fixed point θ_ss(V)
//   FrictionResponse respond(double V, const States&) const;   force, derivatives and state rates from one call
//   template <...> static void fields(Self&, Visitor&)     its parameters (analysis/base/field.h)
//
// and, where it applies,
//
//   std::string problem() const;         what ranges of single numbers cannot say
//   double static_force() const;         set-valued at rest: the largest force at V = 0
//   Level level(double speed) const;     static laws: the resistance without its viscous part
//   DelayList delays(double V) const;    memory that is no state: the impulses of its kernel g about sliding at V
//   KernelTablePtr table() const;        memory that is no state: the sampled part of g
//
// V is the sliding velocity; friction opposes it, so a positive force acts against positive V.
#pragma once
#include <array>
#include <cmath>
#include <string_view>

#include "analysis/base/field.h"

namespace stickslip {

/// One number for each state; those beyond states() are 0.
using States = std::array<double, max_states>;

/// f(V, θ) and θ̇ = h(V, θ), (2)-(3), at one instant: f, ∂f/∂V at constant state, and for each state θ_i: ∂f/∂θ_i, θ̇_i,
/// ∂θ̇_i/∂V, ∂θ̇_i/∂θ_i. In every law here a state evolves by itself (∂θ̇_i/∂θ_j = 0 for i ≠ j).
struct FrictionResponse {
    double force = 0;           ///< f [N | N·m]
    double by_velocity = 0;     ///< ∂f/∂V [N·s/m | N·m·s/rad]
    States by_state{};          ///< ∂f/∂θ_i [effort per the unit of θ_i]
    States rate{};              ///< θ̇_i [unit of θ_i per s]
    States rate_by_velocity{};  ///< ∂θ̇_i/∂V
    States rate_by_state{};     ///< ∂θ̇_i/∂θ_i [1/s]
};

/// A resistance that depends on speed, and its slope with speed.
struct Level {
    double value = 0, slope = 0;  ///< [N | N·m], [N·s/m | N·m·s/rad]
};

/// A static law made of a level and viscous friction: f = (g(|V|) + F_v |V|) sgn V; at rest the middle of its values.
inline FrictionResponse slide(const Level& level, double viscous, double V)
{
    FrictionResponse r;
    r.force = V == 0 ? 0 : std::copysign(level.value + viscous * std::abs(V), V);
    r.by_velocity = level.slope + viscous;
    return r;
}

/// An impulse of the kernel: g(t) = … + weight · δ(t − time).
struct Delay {
    double weight = not_set, time = not_set;  ///< [N·s/m | N·m·s/rad], s

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"weight", Quantity::damping, any_finite, Need::required, "weight of the delayed velocity in g"},
                     self.weight);
        visit.number({"time", Quantity::time, positive, Need::required, "by how much the velocity is delayed"},
                     self.time);
    }
};

inline constexpr int max_delays = 8;  ///< of one body's friction
/// The delays of one law.
using DelayList = ShortList<Delay, max_delays>;

/// What a law is, for `list laws`, for the generic property test, and for the choice of solver.
struct LawInfo {
    std::string_view name;                 ///< as in joint.toml
    std::string_view formula;              ///< in letters of its keys
    std::string_view source;               ///< the paper, with the equation
    std::string_view validity;             ///< where it stops being valid
    bool steady_state_dependence = false;  ///< property (1) of the paper: f_ss depends on V
    bool direct_effect = false;            ///< property (2): a step of V changes f at once, in the same direction
    bool slip_distance = false;            ///< property (3): decay over a characteristic slip distance
    bool set_valued_at_rest = false;       ///< at V = 0 the force is any value within ±static_force()
    bool needs_motion = false;             ///< undefined at V ≤ 0
    bool odd = false;                      ///< f_ss(−V) = −f_ss(V)
    bool dissipative = false;              ///< f V ≥ 0 at every velocity and state, not in steady sliding alone
    bool needs_history = false;            ///< its memory is no finite set of states: past velocities are needed
    bool linear_only = false;              ///< a linear law by definition: no nonlinear outcome exists
};

}  // namespace stickslip
