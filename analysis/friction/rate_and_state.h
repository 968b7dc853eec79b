// Rate-and-state friction, slip law: friction that remembers over a slip distance.
#pragma once
#include <cmath>
#include <string>

#include "analysis/friction/response.h"

namespace stickslip {

/// What the laws of the rate-and-state family share: their parameters and their steady sliding. States θ_i are forces:
/// f = f0 + A ln(V/V*) + Σ θ_i with θ_i = −B_i ln(V/V*) in steady sliding, so that
/// f_ss = f0 + (A − Σ B_i) ln(V/V*)                                                        (6)
struct RateStateParameters {
    double f0 = not_set;      ///< friction at V*
    double A = not_set;       ///< direct effect
    NumberList B{};           ///< evolution effect of each state
    NumberList L{};           ///< slip distance of each state
    double V_star = not_set;  ///< reference velocity

    int states() const { return B.size; }

    double steady_force(double V) const
    {
        double slope = A;
        for (double b : B) slope -= b;
        return f0 + slope * std::log(V / V_star);
    }

    States steady_state(double V) const
    {
        const double logarithm = std::log(V / V_star);
        States theta{};
        for (int i = 0; i < B.size; ++i) theta[i] = -B[i] * logarithm;
        return theta;
    }

    /// What ranges cannot say: every state needs its B and its L.
    std::string problem() const
    {
        return B.size == L.size ? ""
                                : "B and L need one value a state each, got " + std::to_string(B.size) + " and " +
                                      std::to_string(L.size);
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(
            Field{"f0", Quantity::effort, any_finite, Need::required, "friction at the reference velocity", Role::label}
                .called("f_{0}", "friction at the reference velocity"),
            self.f0);
        visit.number(Field{"A", Quantity::effort, positive, Need::required, "direct velocity effect"}.called(
                         "A", "direct effect"),
                     self.A);
        visit.numbers(
            Field{"B", Quantity::effort, not_negative, Need::required, "evolution effect, one value a state"}.called(
                "B", "evolution effect"),
            self.B);
        visit.numbers(
            Field{"L", Quantity::position, positive, Need::required, "characteristic slip distance, one value a state"}
                .called("L", "slip distance"),
            self.L);
        visit.number(
            Field{"V_star", Quantity::velocity, positive, Need::required, "reference velocity V*", Role::label}.called(
                "V*", "reference velocity"),
            self.V_star);
    }
};

/// How one state changes: θ̇ and its derivatives with speed and state.
struct Evolution {
    double rate, by_speed, by_state;
};

/// θ̇ = −(V/L)(θ + B ln(V/V*)): the slip law, (5). Nothing happens at rest.
inline Evolution slip_evolution(double B, double L, double speed, double logarithm, double theta)
{
    if (speed == 0) return {0, 0, 0};
    const double distance_to_steady = theta + B * logarithm;
    return {-speed / L * distance_to_steady, -(distance_to_steady + B) / L, -speed / L};
}

/// f = f0 + A ln(V/V*) + Σ θ_i,   θ̇_i = −(V/L_i)(θ_i + B_i ln(V/V*))                      (2)-(5)
/// Source: Dupont (1991), eqs. (2)-(6); Ruina (1983). The paper calls V* V_0; here V_0 is the commanded velocity.
struct RateAndState : RateStateParameters {
    static constexpr LawInfo info{
        .name = "rate-and-state",
        .formula = "f = f0 + A ln(V/V*) + sum theta_i, theta_i' = -(V/L_i)(theta_i + B_i ln(V/V*))",
        .source = "Dupont 1991, (2)-(6); Ruina 1983 (slip law)",
        .validity = "V > 0; the logarithm has no meaning at rest or in reverse",
        .steady_state_dependence = true,
        .direct_effect = true,
        .slip_distance = true,
        .needs_motion = true,
    };

    FrictionResponse respond(double V, const States& theta) const
    {
        const double logarithm = std::log(V / V_star);
        FrictionResponse r;
        r.force = f0 + A * logarithm;
        r.by_velocity = A / V;
        for (int i = 0; i < B.size; ++i) {
            const auto change = slip_evolution(B[i], L[i], V, logarithm, theta[i]);
            r.force += theta[i];
            r.by_state[i] = 1;
            r.rate[i] = change.rate;
            r.rate_by_velocity[i] = change.by_speed;
            r.rate_by_state[i] = change.by_state;
        }
        return r;
    }
};

}  // namespace stickslip
