// The critical position gain in closed form, for friction with one state on a single mass.
#pragma once
#include <optional>

#include "analysis/stability/linear_friction.h"

namespace stickslip {

struct CriticalGain {
    double k_p;    ///< k_cr
    double omega;  ///< rad/s
};

/// Solves (34) and (35) for one state, g(t) = γ e^{λt}, with C = k_v + f_v:
///   C = γ|λ| / (λ² + ω²)   ⇒   ω² = |λ| (γ − C|λ|) / C
///   k_cr = m ω² + ω · γω/(λ² + ω²) = ω² (m + C/|λ|)
/// For (4)-(5), γ = B/L and λ = −V_0/L, this reads k_cr = ((B − A − k_v V_0)/L)(1 + m V_0/(L C)).
/// Nothing where the imaginary axis is not crossed: C ≥ γ/|λ| (stable for every k_p > 0), or C ≤ 0 (unstable for every
/// k_p), or beyond all numbers. Source: Dupont (1991), (33)-(37).
inline std::optional<CriticalGain> critical_gain(double inertia, double k_v, const LinearFriction& friction)
{
    if (friction.states != 1) return std::nullopt;
    const double C = k_v + friction.f_v;
    const double gamma = friction.weight(0), decay = -friction.lambda[0];
    const double omega_squared = decay * (gamma - C * decay) / C;
    if (!(C > 0 && decay > 0 && omega_squared > 0)) return std::nullopt;
    const double k_cr = omega_squared * (inertia + C / decay);
    if (!std::isfinite(k_cr)) return std::nullopt;
    return CriticalGain{k_cr, std::sqrt(omega_squared)};
}

}  // namespace stickslip
