// The critical position gain in closed form, for friction with one state on a single mass.
#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/stability/linear_friction.h"

namespace stickslip {

/// Where a pair of roots lies on the imaginary axis: stable for k_p above, unstable below.
struct CriticalGain {
    double k_p;    ///< k_cr [N/m | N·m/rad]
    double omega;  ///< of the oscillation there [rad/s]
};

/// Sets s = iω in m s² + (k_v + f_v − γ/(s − λ)) s + k_p = 0, the kernel g(t) = γ e^{λt} of one state, λ < 0, and
/// solves its imaginary and its real part, (34) and (35), with C = k_v + f_v:
///   C = γ|λ| / (λ² + ω²)   ⇒   ω² = |λ| (γ − C|λ|) / C
///   k_cr = m ω² + ω · γω/(λ² + ω²) = ω² (m + C/|λ|)
/// For rate-and-state friction under the slip law, (4)-(5), γ = B/L and λ = −V_0/L, this reads k_cr = ((B − A − k_v
/// V_0)/L)(1 + m V_0/(L C)). Nothing where the imaginary axis is not crossed: C ≥ γ/|λ| (stable for every k_p > 0), or
/// C ≤ 0 (unstable for every k_p), or beyond all numbers. Source: Dupont (1991), (33)-(37).
inline std::optional<CriticalGain> critical_gain(double inertia, double k_v, const LinearFriction& friction)
{
    if (friction.states != 1) return std::nullopt;
    const double C = k_v + friction.f_v;
    const double gamma = friction.weight(0), decay = -friction.lambda[0];
    const double excess = gamma - C * decay, omega_squared = decay * excess / C;
    if (!(C > 0 && decay > 0 && excess > 0)) return std::nullopt;
    double k_cr = omega_squared * (inertia + C / decay), omega = std::sqrt(omega_squared);
    // the slowest velocities have frequencies whose squares are no numbers
    if (omega_squared < std::numeric_limits<double>::min()) {
        k_cr = excess * (1 + inertia * (decay / C));
        omega = std::sqrt(decay) * std::sqrt(excess / C);
    }
    if (!std::isfinite(k_cr)) return std::nullopt;
    return CriticalGain{k_cr, omega};
}

}  // namespace stickslip
