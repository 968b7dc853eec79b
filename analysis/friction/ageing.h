// Rate-and-state friction, ageing law: contacts that also strengthen at rest.
#pragma once
#include "analysis/friction/rate_and_state.h"

namespace stickslip {

/// With the age φ of the contacts, φ̇ = 1 − Vφ/L, the state θ = B ln(V* φ/L) obeys
///   θ̇ = (B/L)(V* e^{−θ/B} − V)
/// and has the steady state and, about it, the linearisation of the slip law. The logarithm of the age is kept rather
/// than the age, which spans as many decades as V.
inline Evolution ageing_evolution(double B, double L, double V_star, double speed, double theta)
{
    if (B == 0) return {0, 0, -speed / L};
    const double renewal = V_star / L * std::exp(-theta / B);
    return {B * (renewal - speed / L), -B / L, -renewal};
}

/// f = f0 + A ln(V/V*) + Σ θ_i,   θ̇_i = (B_i/L_i)(V* e^{−θ_i/B_i} − V)
/// Source: Dieterich (1979), Ruina (1983); f_ss is that of (6).
struct Ageing : RateStateParameters {
    static constexpr LawInfo info{
        .name = "ageing",
        .formula = "f = f0 + A ln(V/V*) + sum theta_i, theta_i' = (B_i/L_i)(V* exp(-theta_i/B_i) - V)",
        .source = "Dieterich 1979; Ruina 1983 (ageing law)",
        .validity = "V > 0; the direct effect has no meaning at rest or in reverse",
        .steady_state_dependence = true,
        .direct_effect = true,
        .slip_distance = true,
        .needs_motion = true,
    };

    FrictionResponse respond(double V, const States& theta) const
    {
        FrictionResponse r;
        r.force = f0 + A * std::log(V / V_star);
        r.by_velocity = A / V;
        for (int i = 0; i < B.size; ++i) {
            const auto change = ageing_evolution(B[i], L[i], V_star, V, theta[i]);
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
