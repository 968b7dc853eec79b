// The concept that all friction laws share. A law is a plain struct of named parameters with
//
//   static constexpr LawInfo info;
//   int states() const;                                    how many internal states θ_i it has
//   double steady_force(double V) const;                   f_ss(V), the friction-velocity curve of steady sliding
//   States steady_state(double V) const;                   the fixed point θ_ss(V)
//   FrictionResponse respond(double V, const States&) const;   force, derivatives and state rates from one call
//   template <...> static void fields(Self&, Visitor&)     its parameters (analysis/joint/field.h)
//
// V is the sliding velocity; friction opposes it, so a positive force acts against positive V.
#pragma once
#include <array>
#include <string_view>

#include "analysis/joint/field.h"

namespace stickslip {

using States = std::array<double, max_states>;

/// (2)-(3) at one instant: f, ∂f/∂V at constant state, and for each state θ_i: ∂f/∂θ_i, θ̇_i, ∂θ̇_i/∂V, ∂θ̇_i/∂θ_i.
/// In every law here a state evolves by itself (∂θ̇_i/∂θ_j = 0 for i ≠ j).
struct FrictionResponse {
    double force = 0;
    double by_velocity = 0;
    States by_state{};
    States rate{};
    States rate_by_velocity{};
    States rate_by_state{};
};

/// What a law is, for `list laws`, for the generic property test, and for the choice of solver.
struct LawInfo {
    std::string_view name;  ///< as in joint.toml
    std::string_view formula;
    std::string_view source;
    std::string_view validity;             ///< where it stops being valid
    bool steady_state_dependence = false;  ///< property (1) of the paper: f_ss depends on V
    bool direct_effect = false;            ///< property (2): a step of V changes f at once, in the same direction
    bool slip_distance = false;            ///< property (3): decay over a characteristic slip distance
    bool set_valued_at_rest = false;       ///< at V = 0 the force is any value within ±static_force()
    bool needs_motion = false;             ///< undefined at V ≤ 0
    bool odd = false;                      ///< f_ss(−V) = −f_ss(V)
};

}  // namespace stickslip
