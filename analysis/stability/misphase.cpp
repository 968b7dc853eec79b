#include "analysis/stability/misphase.h"

namespace stickslip {
namespace {

#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;
#endif

struct WideComplex {
    Wide re = 0, im = 0;

    WideComplex() = default;
    WideComplex(double real) : re(real) {}
    WideComplex(Wide real, Wide imaginary) : re(real), im(imaginary) {}
};
WideComplex operator+(const WideComplex& a, const WideComplex& b)
{
    return {a.re + b.re, a.im + b.im};
}
WideComplex operator-(const WideComplex& a, const WideComplex& b)
{
    return {a.re - b.re, a.im - b.im};
}
WideComplex operator*(const WideComplex& a, const WideComplex& b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// f_v − G(iω)
WideComplex resistance_of(const LinearFriction& f, Wide omega)
{
    WideComplex sum(f.f_v);
    for (int k = 0; k < f.states; ++k) {
        // w/(iω − λ) = −w (λ + iω)/(λ² + ω²)
        const Wide lambda = f.lambda[k], weight = Wide(-f.h[k]) * Wide(f.b[k]);
        const Wide part = weight / (lambda * lambda + omega * omega);
        sum = sum + WideComplex(part * lambda, part * omega);
    }
    return sum;
}

/// −(m_jk s²)²/D_k per s, at s = iω: i m_jk² ω³/D_k, D_k = k − m_kk ω² + i c ω.
WideComplex share_of(const LinearNeighbour& n, Wide omega)
{
    const Wide re = Wide(n.stiffness) - Wide(n.inertia) * omega * omega, im = Wide(n.damping) * omega;
    const Wide factor = Wide(n.coupling) * Wide(n.coupling) * omega * omega * omega / (re * re + im * im);
    return {factor * im, factor * re};
}

}  // namespace

double certain_misphase(const LinearJoint& j, Gain gain, double omega)
{
    constexpr double enough = 1e-8;  // of |a b|: more than rounding loses of sums of a few terms of one size
    const Complex at(0, omega);
    const auto parts = split_by(gain, characteristic_at(j, at), j.k_p, j.k_v, Dual<Complex>(at, 1.0));
    const double value = std::imag(parts.a.value * std::conj(parts.b.value));
    if (std::abs(value) > enough * std::abs(parts.a.value) * std::abs(parts.b.value)) return value;
    std::array<WideComplex, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = resistance_of(j.friction[i], omega);
        scale[i] = 1.0;
    }
    for (const auto& n : j.neighbour) resistance[j.link()] = resistance[j.link()] + share_of(n, omega);
    const WideComplex s(Wide(0), Wide(omega));
    const auto wide = split_by(gain, characteristic(j, s, resistance, scale), j.k_p, j.k_v, s);
    return static_cast<double>(wide.a.im * wide.b.re - wide.a.re * wide.b.im);
}

}  // namespace stickslip
