// How fast a disturbance has to grow, and for how long, to be measured.
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stickslip {

/// How much of |s| a measured growth rate must be before its sign counts; below, the spectrum decides.
inline constexpr double measurable_growth = 1e-6;

/// Over which the growth of a small disturbance along the mode s is measured: one turn, or a factor of 3 if that comes
/// first.
inline double growth_window(std::complex<double> s)
{
    return std::min(2 * std::numbers::pi / std::abs(s.imag()), std::log(3.0) / std::abs(s.real()));
}

}  // namespace stickslip
