// Eigenvalues to their last digits. Internal to analysis/stability.
#pragma once
#include <complex>

namespace stickslip {

/// Newton's method from an eigenvalue `s` that a matrix gave. `drift(s)` is d log P/ds of an entire function P whose
/// roots are wanted, infinite or NaN on a root. Keeps the start where Newton's method does not stay near it.
template <class Drift>
std::complex<double> polished(std::complex<double> s, const Drift& drift)
{
    constexpr int steps = 4;
    constexpr double near = 1e-4, exact = 1e-15;  // of |s|
    for (int i = 0; i < steps; ++i) {
        const std::complex<double> step = 1.0 / drift(s);
        if (!(std::abs(step) < near * std::abs(s))) break;
        s -= step;
        if (std::abs(step) < exact * std::abs(s)) break;
    }
    return s;
}

}  // namespace stickslip
