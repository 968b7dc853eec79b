#include "analysis/stability/joint_spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "analysis/stability/balance.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/delay_spectrum.h"
#include "analysis/stability/frequency_search.h"

namespace stickslip {
namespace {

/// Newton on F itself. Keeps the start if it does not stay near.
Complex polished(const LinearJoint& j, Complex start)
{
    Complex s = start;
    for (int i = 0; i < 4; ++i) {
        const auto F = closed_loop(j, s);
        const Complex step = F.value / F.slope;
        if (!(std::abs(step) < 1e-4 * std::abs(s))) break;
        s -= step;
        if (std::abs(step) < 1e-15 * std::abs(s)) break;
    }
    return s;
}

bool further_right(const Complex& a, const Complex& b)
{
    return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
}

}  // namespace

Eigen::MatrixXd state_matrix(const LinearJoint& j)
{
    const int n = j.bodies;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(j.states(), j.states());
    int state = 2 * n;
    for (int i = 0; i < n; ++i) {
        const double m = j.inertia[i];
        A(i, n + i) = 1;
        for (int k = 0; k < n; ++k) {
            A(n + i, k) = -j.stiffness_at(i, k) / m;
            A(n + i, n + k) = -j.damping_at(i, k) / m;
        }
        A(n + i, j.measured) -= j.actuated[i] * j.k_p / m;
        A(n + i, n + j.measured) -= j.actuated[i] * j.k_v / m;
        const auto& f = j.friction[i];
        A(n + i, n + i) -= f.f_v / m;
        for (int k = 0; k < f.states; ++k, ++state) {
            A(n + i, state) = -f.h[k] / m;
            A(state, n + i) = f.b[k];
            A(state, state) = f.lambda[k];
        }
    }
    return A;
}

RationalCharacteristic rational_characteristic(const LinearJoint& j)
{
    std::array<Polynomial, max_bodies> resistance, denominator;
    for (int i = 0; i < j.bodies; ++i) {
        const auto& f = j.friction[i];
        Polynomial product(1.0), numerator(0.0);  // G = numerator / product, built up state by state
        for (int k = 0; k < f.states; ++k) {
            const Polynomial pole(-f.lambda[k], 1);
            numerator = numerator * pole + Polynomial(f.weight(k)) * product;
            product = product * pole;
        }
        denominator[i] = product;
        resistance[i] = Polynomial(f.f_v) * product - numerator;
    }
    const auto parts = characteristic(j, Polynomial(0, 1), resistance, denominator);
    return {trimmed(parts.a), trimmed(parts.b)};
}

bool is_stable(const LinearJoint& j)
{
    if (!j.rational()) {
        const auto count = roots_right_of(j, 0);
        return count && *count == 0;
    }
    const auto parts = rational_characteristic(j);
    return is_hurwitz(trimmed(parts.a + Polynomial(j.k_p, j.k_v) * parts.b));
}

std::vector<Complex> spectrum(const LinearJoint& j)
{
    std::vector<Complex> roots;
    if (j.rational()) {
        Eigen::MatrixXd A = state_matrix(j);
        if (!A.allFinite()) return {};
        balance(A);
        for (const Complex& s : Eigen::VectorXcd(A.eigenvalues())) roots.push_back(polished(j, s));
    } else {
        roots = rightmost_roots(j);
    }
    std::sort(roots.begin(), roots.end(), further_right);
    return roots;
}

double spectral_abscissa(const LinearJoint& j)
{
    if (!j.rational()) return confirmed_abscissa(j, spectrum(j));
    Eigen::MatrixXd A = state_matrix(j);
    if (!A.allFinite()) return missing;
    balance(A);
    const Eigen::VectorXcd values = A.eigenvalues();
    Complex rightmost = values[0];
    for (const Complex& s : values)
        if (s.real() > rightmost.real()) rightmost = s;
    return polished(j, rightmost).real();
}

}  // namespace stickslip
