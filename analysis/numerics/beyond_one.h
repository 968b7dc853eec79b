// The exponential and the logarithm of complex numbers near 1 with their digits, as expm1 and log1p have for real ones.
#pragma once
#include <cmath>
#include <complex>

namespace stickslip {

/// e^x − 1.
inline std::complex<double> beyond_one(std::complex<double> x)
{
    const double half = std::sin(x.imag() / 2), grown = std::exp(x.real());
    return {std::expm1(x.real()) - 2 * grown * half * half, grown * std::sin(x.imag())};
}

/// ln(1 + v).
inline std::complex<double> log_beyond_one(std::complex<double> v)
{
    return {0.5 * std::log1p(2 * v.real() + std::norm(v)), std::arg(1.0 + v)};
}

}  // namespace stickslip
