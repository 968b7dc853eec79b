// Friction linearised about steady sliding: direct effect, memory, and its transfer function.
#pragma once
#include <complex>

#include "analysis/friction/friction.h"

namespace stickslip {

/// δf = f_v v − g * v as a state form, δθ_i' = λ_i δθ_i + b_i v, δf = f_v v + Σ h_i δθ_i, so that
/// g(t) = −Σ h_i b_i e^{λ_i t} and G(s) = −Σ h_i b_i / (s − λ_i). Source: Dupont (1991), (12)-(15).
struct LinearFriction {
    double f_v = 0;  ///< (14), direct effect
    int states = 0;
    States lambda{}, b{}, h{};

    /// −h_i b_i: the weight of state i in the kernel g.
    double weight(int i) const { return -h[i] * b[i]; }
};

/// The friction of one body about steady sliding at V ≠ 0. Position-locked and time-locked terms (ripple, drift) are
/// not part of a time-invariant linear theory and are left out.
LinearFriction linearise(const Friction& friction, double V);

/// G(s), the Laplace transform of the kernel g.
std::complex<double> transfer(const LinearFriction& friction, std::complex<double> s);

/// ∫g = G(0).
double kernel_integral(const LinearFriction& friction);

/// df_ss/dV = f_v − ∫g                                                                     (15)
double steady_slope(const LinearFriction& friction);

/// Friction of steady sliding at V, every term of the body included that does not depend on position or time.
double steady_force(const Friction& friction, double V);

}  // namespace stickslip
