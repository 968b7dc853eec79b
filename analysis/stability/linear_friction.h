// Friction linearised about steady sliding: direct effect, memory, and its transfer function.
#pragma once
#include <complex>

#include "analysis/friction/friction.h"

namespace stickslip {

/// δf = f_v v − g * v                                                                      (12)-(15)
/// The kernel's exponentials are states, δθ_i' = λ_i δθ_i + b_i v, δf = f_v v + Σ h_i δθ_i, so that
///   g(t) = −Σ h_i b_i e^{λ_i t} + Σ w_j δ(t − τ_j) + table,
///   G(s) = −Σ h_i b_i / (s − λ_i) + Σ w_j e^{−s τ_j} + L{table}: one type for every law.
struct LinearFriction {
    double f_v = 0;  ///< (14), direct effect
    int states = 0;
    States lambda{}, b{}, h{};
    DelayList delays{};
    KernelTablePtr table{};
    double table_scale = 1;

    /// −h_i b_i: the weight of state i in the kernel g.
    double weight(int i) const { return -h[i] * b[i]; }
    /// Whether G is a rational function, so that the joint has finitely many roots.
    bool rational() const { return delays.size == 0 && !table; }
};

/// The friction of one body about steady sliding at V ≠ 0. Position-locked and time-locked terms (ripple, drift) are
/// not part of a time-invariant linear theory and are left out. A state that steady sliding neither moves nor lets
/// decay (a saturated bristle or element) is left out, too.
LinearFriction linearise(const Friction& friction, double V);

/// `factor` times the friction.
LinearFriction scaled(LinearFriction friction, double factor);

/// The friction behind a reduction N as the joint side feels it: δf' = N δf(N v).
LinearFriction reflected(LinearFriction friction, double N);

/// G(s), the Laplace transform of the kernel g, and dG/ds.
std::complex<double> transfer(const LinearFriction& friction, std::complex<double> s);
std::complex<double> transfer_slope(const LinearFriction& friction, std::complex<double> s);

/// ∫g = G(0).
double kernel_integral(const LinearFriction& friction);

/// df_ss/dV = f_v − ∫g                                                                     (15)
double steady_slope(const LinearFriction& friction);

}  // namespace stickslip
