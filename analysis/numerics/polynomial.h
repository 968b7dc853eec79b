// Roots of real cubics, accurate to rounding: the spectrum of the single mass with one state, millions of times a
// second.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace stickslip {

/// Both roots of s² + p s + q without cancellation.
inline std::array<std::complex<double>, 2> quadratic_roots(double p, double q)
{
    const double half = -p / 2, discriminant = half * half - q;
    if (discriminant < 0) {
        const double imaginary = std::sqrt(-discriminant);
        return {{{half, imaginary}, {half, -imaginary}}};
    }
    const double larger = half + std::copysign(std::sqrt(discriminant), half);
    return {{{larger, 0}, {larger != 0 ? q / larger : 0, 0}}};
}

/// The real root of s³ + a s² + b s + c that lies outermost: Newton from beyond it converges monotonically.
/// Source of the starting point: W. Kahan, To Solve a Real Cubic Equation (1986).
inline double outermost_real_root(double a, double b, double c)
{
    const auto value = [&](double s) { return ((s + a) * s + b) * s + c; };
    const auto slope = [&](double s) { return (3 * s + 2 * a) * s + b; };
    double s = -a / 3;
    const double q = value(s);
    if (q == 0) return s;
    double reach = std::cbrt(std::abs(q));
    const double depth = -slope(s);
    constexpr double plastic = 1.3247179572447460260;  // real root of x³ = x + 1
    if (depth > 0) reach = plastic * std::max(reach, std::sqrt(depth));
    s -= std::copysign(reach, q);
    for (int i = 0; i < 100; ++i) {
        const double step = value(s) / slope(s);
        const double next = s - step;
        if (!(std::abs(step) > 1e-15 * std::abs(s))) return next;
        s = next;
    }
    return s;
}

/// The two small roots of s³ + a s² + b s + c where the large one, r, leaves no number of c in its own units: in units
/// of theirs.
inline std::array<std::complex<double>, 2> roots_beside_large(double r, double b, double c)
{
    const double unit = std::max(std::abs(b / r), std::sqrt(std::abs(c)) / std::sqrt(std::abs(r)));
    const double q = -(c / unit) / (r * unit), p = (q * unit - b / unit) / r;
    auto pair = quadratic_roots(p, q);
    for (auto& s : pair) s *= unit;
    return pair;
}

/// All roots of s³ + a s² + b s + c; a real one first, then the other two.
inline std::array<std::complex<double>, 3> cubic_roots(double a, double b, double c)
{
    // in units of `scale` every coefficient is at most one, so nothing overflows on the way
    const double scale = std::max({std::abs(a), std::sqrt(std::abs(b)), std::cbrt(std::abs(c))});
    if (!(scale > 0) || !std::isfinite(scale)) return {{{c == 0 ? 0 : c, 0}, {0, 0}, {0, 0}}};
    const double A = a / scale, B = b / scale / scale, C = c / scale / scale / scale;
    const double r = outermost_real_root(A, B, C);
    if (c != 0 && std::abs(C) < std::numeric_limits<double>::min()) {
        const auto pair = roots_beside_large(r * scale, b, c);
        return {{{r * scale, 0}, pair[0], pair[1]}};
    }
    // (s − r)(s² + p s + q): a large root is divided out from the constant end, a small one from the leading end
    const bool large = std::abs(r * r * r) > std::abs(C);
    const double q = large ? -C / r : B + r * (A + r);
    const double p = large ? (q - B) / r : A + r;
    const auto pair = quadratic_roots(p, q);
    std::array<std::complex<double>, 3> roots{{{r, 0}, pair[0], pair[1]}};
    for (auto& s : roots) {  // one Newton step on the undeflated cubic removes the error of the deflation
        const auto slope = (3.0 * s + 2 * A) * s + B;
        const auto step = (((s + A) * s + B) * s + C) / slope;
        if (std::norm(step) < 1e-8 * std::norm(s)) s -= step;
        s *= scale;
    }
    return roots;
}

}  // namespace stickslip
