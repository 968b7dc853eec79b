// Neutral sliding: a root on the imaginary axis, whose computed real part is nothing but rounding.
#pragma once
#include <cmath>
#include <complex>
#include <limits>

#include "analysis/numerics/polynomial_arithmetic.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/spectrum.h"

namespace stickslip {

/// |Re s| per |s| above which no rounding moves a root across the imaginary axis.
inline constexpr double near_axis = 1e-6;

/// Sufficient for clear_of_rounding to say the root's own real part, whatever terms and slope are: by the sum of the
/// parts, which is no smaller than |s| and takes no square root.
inline bool far_from_axis(std::complex<double> root)
{
    const double real = std::abs(root.real());
    return !std::isfinite(root.real()) || real > near_axis * (real + std::abs(root.imag()));
}

/// What a computed real part is worth: exactly 0 where it is within the error of the root, so that "neutral" is one
/// number and not a tolerance at each use. To first order a root is off by |δF|/|F'|, and |δF| by a few units in the
/// last place of the largest terms of F: `terms` is the sum of their sizes at the root, `slope` is F'.
/// Roots that are not next to the axis for their own size are returned as they are: there a multiple root (F' = 0) says
/// nothing of the side.
inline double clear_of_rounding(std::complex<double> root, double terms, std::complex<double> slope)
{
    constexpr double roundings = 32;
    if (!std::isfinite(root.real()) || std::abs(root.real()) > near_axis * std::abs(root)) return root.real();
    const double error = roundings * std::numeric_limits<double>::epsilon() * terms / std::abs(slope);
    return std::abs(root.real()) <= error ? 0 : root.real();
}

/// The real part of a root of (27).
double side_of_axis(const LinearMass& mass, std::complex<double> root);

/// The real part of a root of a joint with delays or a table.
double side_of_axis(const LinearJoint& joint, std::complex<double> root);

/// Whether the real part of the largest root of a rational joint may drown in the rounding of its eigenvalue problem
/// ("may": polynomial_side_of_axis tells). `radius`: the size of the joint's largest root.
inline bool may_be_rounding(std::complex<double> root, double radius)
{
    constexpr double doubtful = 1e-9;
    return std::abs(root.real()) <= std::max(doubtful * radius, near_axis * std::abs(root));
}

/// The real part of a root of a rational joint, from a near start by Newton's method on the characteristic polynomial,
/// whose coefficients keep what eigenvalues of a stiff joint lose.
double polynomial_side_of_axis(const Polynomial& characteristic, std::complex<double> start);

/// C = k_v + f_ss' at some k_v of the velocity-only theory, 0 where m s² + C s + k_p decays or grows by rounding only.
double velocity_only_damping(const LinearMass& mass, double k_v);

}  // namespace stickslip
