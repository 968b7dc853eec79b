// The characteristic function of a linear joint for any kind of number: complex values, values with derivatives,
// rectangles of the plane, polynomials in s.
#pragma once
#include <array>

#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// A value and its derivative.
template <class T>
struct Dual {
    T value, slope;

    Dual() = default;
    Dual(double v) : value(v), slope(0.0) {}
    Dual(const T& v, const T& s) : value(v), slope(s) {}
};
template <class T>
Dual<T> operator+(const Dual<T>& a, const Dual<T>& b)
{
    return {a.value + b.value, a.slope + b.slope};
}
template <class T>
Dual<T> operator-(const Dual<T>& a, const Dual<T>& b)
{
    return {a.value - b.value, a.slope - b.slope};
}
template <class T>
Dual<T> operator*(const Dual<T>& a, const Dual<T>& b)
{
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}

/// F(s) = a(s) + (k_p + k_v s) b(s): the loop enters with rank one.
template <class T>
struct Characteristic {
    T a, b;
};

/// Z(s) without the loop: inertias, springs, dampers, contact and friction. `resistance[i]` is f_v − G(s) of body i;
/// `scale[i]` multiplies row i (1, or the denominator of G where T is a polynomial), already within `resistance`.
template <class T>
std::array<std::array<T, max_bodies>, max_bodies> open_loop_matrix(const LinearJoint& j, const T& s,
                                                                   const std::array<T, max_bodies>& resistance,
                                                                   const std::array<T, max_bodies>& scale)
{
    std::array<std::array<T, max_bodies>, max_bodies> Z{};
    for (int i = 0; i < j.bodies; ++i)
        for (int k = 0; k < j.bodies; ++k) {
            T entry = T(j.stiffness_at(i, k)) + T(j.damping_at(i, k)) * s;
            if (i == k) entry = entry + T(j.inertia[i]) * s * s;
            Z[i][k] = scale[i] * entry;
            if (i == k) Z[i][k] = Z[i][k] + resistance[i] * s;
        }
    return Z;
}

/// det Z, and b = Σ u_i C_im with the cofactors C of the measured column: det(Z + g u eᵀ_m) = det Z + g b.
template <class T>
Characteristic<T> characteristic(const LinearJoint& j, const T& s, const std::array<T, max_bodies>& resistance,
                                 const std::array<T, max_bodies>& scale)
{
    const auto Z = open_loop_matrix(j, s, resistance, scale);
    const int m = j.measured;
    const auto u = [&](int i) { return T(j.actuated[i]) * scale[i]; };
    if (j.bodies == 1) return {Z[0][0], u(0)};
    if (j.bodies == 2) {
        const T b = m == 0 ? u(0) * Z[1][1] - u(1) * Z[0][1] : u(1) * Z[0][0] - u(0) * Z[1][0];
        return {Z[0][0] * Z[1][1] - Z[0][1] * Z[1][0], b};
    }
    // cyclic indices carry the signs of the cofactors
    const auto cofactor = [&](int i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, m1 = (m + 1) % 3, m2 = (m + 2) % 3;
        return Z[i1][m1] * Z[i2][m2] - Z[i1][m2] * Z[i2][m1];
    };
    const std::array<T, 3> C{cofactor(0), cofactor(1), cofactor(2)};
    return {Z[0][m] * C[0] + Z[1][m] * C[1] + Z[2][m] * C[2], u(0) * C[0] + u(1) * C[1] + u(2) * C[2]};
}

using Complex = std::complex<double>;

/// a and b at a complex s, with d/ds.
inline Characteristic<Dual<Complex>> characteristic_at(const LinearJoint& j, Complex s)
{
    std::array<Dual<Complex>, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = {j.friction[i].f_v - transfer(j.friction[i], s), -transfer_slope(j.friction[i], s)};
        scale[i] = Dual<Complex>(1.0);
    }
    for (const auto& n : j.neighbour) {
        // −(m_jk s²)²/D_k = s · (−m_jk² s³/D_k)
        const Complex D = (n.inertia * s + n.damping) * s + n.stiffness, slope = 2.0 * n.inertia * s + n.damping;
        const Complex share = -n.coupling * n.coupling * s * s * s / D;
        auto& own = resistance[j.link()];
        own = own + Dual<Complex>(share, -n.coupling * n.coupling * 3.0 * s * s / D - share * slope / D);
    }
    return characteristic(j, Dual<Complex>(s, 1.0), resistance, scale);
}

/// Which gain of the loop is looked at, the other held.
enum class Gain { k_p, k_v };

/// a and b of F = a + gain · b: the other gain belongs to a.
template <class T>
Characteristic<T> split_by(Gain gain, const Characteristic<T>& parts, double k_p, double k_v, const T& s)
{
    if (gain == Gain::k_p) return {parts.a + T(k_v) * s * parts.b, parts.b};
    return {parts.a + T(k_p) * parts.b, s * parts.b};
}

/// Im(a conj b) at s = iω: zero where a real gain puts a root at iω, the generalisation of (34).
inline double misphase(const LinearJoint& j, Gain gain, double omega)
{
    const Complex s(0, omega);
    const auto parts = split_by(gain, characteristic_at(j, s), j.k_p, j.k_v, Dual<Complex>(s, 1.0));
    return std::imag(parts.a.value * std::conj(parts.b.value));
}

/// The gain −Re(a/b) that puts a root at iω where misphase vanishes, the generalisation of (35).
inline double gain_at(const LinearJoint& j, Gain gain, double omega)
{
    const Complex s(0, omega);
    const auto parts = split_by(gain, characteristic_at(j, s), j.k_p, j.k_v, Dual<Complex>(s, 1.0));
    return -(parts.a.value / parts.b.value).real();
}

/// Sign of Re ds/dgain at the root iω that `value` of the gain causes: +1 where it moves into the right half-plane.
inline int crossing_direction(const LinearJoint& j, Gain gain, double value, double omega)
{
    const Complex s(0, omega);
    const auto parts = split_by(gain, characteristic_at(j, s), j.k_p, j.k_v, Dual<Complex>(s, 1.0));
    const Complex slope = parts.a.slope + value * parts.b.slope;
    return (-parts.b.value / slope).real() > 0 ? 1 : -1;
}

/// F(s) and F'(s) of the closed loop.
inline Dual<Complex> closed_loop(const LinearJoint& j, Complex s)
{
    const auto parts = characteristic_at(j, s);
    return parts.a + Dual<Complex>(j.k_p + j.k_v * s, j.k_v) * parts.b;
}

/// d log(F Π(s − λ))/ds over the rates λ of all friction states: 1/drift is the step of Newton's method for the roots
/// of an entire function, which the poles of G neither catch nor repel. Infinite or NaN on a pole or a root.
inline Complex drift(const LinearJoint& j, Complex s)
{
    const auto F = closed_loop(j, s);
    Complex sum = F.slope / F.value;
    for (int i = 0; i < j.bodies; ++i)
        for (int k = 0; k < j.friction[i].states; ++k)
            if (j.friction[i].weight(k) != 0) sum += 1.0 / (s - j.friction[i].lambda[k]);
    return sum;
}

}  // namespace stickslip
