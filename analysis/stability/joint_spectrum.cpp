#include "analysis/stability/joint_spectrum.h"

#include <algorithm>

#include "analysis/numerics/eigenvalues.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/delay_spectrum.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/polished.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

/// A root that is the rate of a friction state which the motion does not notice stays as it is: the characteristic
/// function F does not contain it.
Complex polished_of(const LinearJoint& j, Complex start)
{
    for (int i = 0; i < j.bodies; ++i)
        for (int k = 0; k < j.friction[i].states; ++k)
            if (j.friction[i].weight(k) == 0 && start == j.friction[i].lambda[k]) return start;
    return polished(start, [&](Complex s) { return drift(j, s); });
}

Polynomial characteristic_polynomial(const LinearJoint& j)
{
    const auto parts = rational_characteristic(j);
    return trimmed(parts.a + Polynomial(j.k_p, j.k_v) * parts.b);
}

/// The eigenvalues of a rational joint as the matrix gives them; empty if the joint is not finite.
std::vector<Complex> raw_eigenvalues(const LinearJoint& j)
{
    const Eigen::VectorXcd values = eigenvalues_of(state_matrix(j));
    return {values.begin(), values.end()};
}

/// Real parts that may be rounding are replaced by what the characteristic polynomial knows of them.
void clear_near_axis(const LinearJoint& j, std::vector<Complex>& roots)
{
    double radius = 0;
    for (const auto& s : roots) radius = std::max(radius, std::abs(s));
    const auto doubtful = [&](const Complex& s) { return may_be_rounding(s, radius); };
    if (std::none_of(roots.begin(), roots.end(), doubtful)) return;
    const auto p = characteristic_polynomial(j);
    int zeros = 0;  // roots that are exactly 0: nothing holds the position
    while (zeros < p.degree() && p.c[zeros] == 0) ++zeros;
    std::sort(roots.begin(), roots.end(), [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
    for (std::size_t i = 0; i < roots.size(); ++i) {
        if (i < static_cast<std::size_t>(zeros))
            roots[i] = 0;
        else if (doubtful(roots[i]))
            roots[i].real(polynomial_side_of_axis(p, roots[i]));
    }
}

bool further_right(const Complex& a, const Complex& b)
{
    return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
}

}  // namespace

namespace {

/// The neighbours' rows and what they push the link with. A, without them, has the link's acceleration at its own
/// inertia; m_kk ẍ_k + m_jk ẍ = −c v_k − k x_k leaves (m − Σ m_jk²/m_kk) ẍ = F + Σ m_jk/m_kk (c v_k + k x_k).
void couple_neighbours(const LinearJoint& j, Eigen::MatrixXd& A)
{
    const int row = j.bodies + j.link(), first = j.states() - 2 * j.neighbour.size;
    double free = j.inertia[j.link()];
    for (const auto& n : j.neighbour) free -= n.coupling * n.coupling / n.inertia;
    A.row(row) *= j.inertia[j.link()] / free;
    for (int i = 0; i < j.neighbour.size; ++i) {
        const auto& n = j.neighbour[i];
        A(row, first + 2 * i) += n.coupling / n.inertia * n.stiffness / free;
        A(row, first + 2 * i + 1) += n.coupling / n.inertia * n.damping / free;
    }
    for (int i = 0; i < j.neighbour.size; ++i) {
        const auto& n = j.neighbour[i];
        const int x = first + 2 * i, v = x + 1;
        A(x, v) = 1;
        A.row(v) = -n.coupling / n.inertia * A.row(row);
        A(v, x) -= n.stiffness / n.inertia;
        A(v, v) -= n.damping / n.inertia;
    }
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
    if (j.neighbour.size > 0) couple_neighbours(j, A);
    return A;
}

Eigen::VectorXd rates_per_force(const LinearJoint& j, int body)
{
    Eigen::VectorXd rates = Eigen::VectorXd::Zero(j.states());
    double& own = rates[j.bodies + body];
    own = 1 / j.inertia[body];
    if (body != j.link() || j.neighbour.size == 0) return rates;
    double free = j.inertia[body];
    for (const auto& n : j.neighbour) free -= n.coupling * n.coupling / n.inertia;
    own = 1 / free;
    const int first = j.states() - 2 * j.neighbour.size;
    for (int i = 0; i < j.neighbour.size; ++i)
        rates[first + 2 * i + 1] = -j.neighbour[i].coupling / j.neighbour[i].inertia / free;
    return rates;
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
    for (const auto& n : j.neighbour) {
        const Polynomial s(0, 1), D = Polynomial(n.stiffness) + s * (Polynomial(n.damping) + Polynomial(n.inertia) * s);
        auto &own = resistance[j.link()], &product = denominator[j.link()];
        own = own * D - Polynomial(n.coupling * n.coupling) * s * s * s * product;
        product = product * D;
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
    switch (routh(characteristic_polynomial(j))) {
        case Routh::all_decay:
            return true;
        case Routh::not_all_decay:
            return false;
        case Routh::rounding_decides:
            break;
    }
    return spectral_abscissa(j) < 0;
}

std::vector<Complex> spectrum(const LinearJoint& j)
{
    std::vector<Complex> roots;
    if (j.rational()) {
        roots = raw_eigenvalues(j);
        for (auto& s : roots) s = polished_of(j, s);
        clear_near_axis(j, roots);
    } else {
        roots = rightmost_roots(j);
        for (auto& s : roots) s.real(side_of_axis(j, s));
    }
    std::sort(roots.begin(), roots.end(), further_right);
    return roots;
}

double spectral_abscissa(const LinearJoint& j)
{
    if (!j.rational()) return delayed_abscissa(j);
    auto roots = raw_eigenvalues(j);
    if (roots.empty()) return missing;
    // further right comes first
    auto rightmost = std::min_element(roots.begin(), roots.end(), further_right);
    *rightmost = polished_of(j, *rightmost);
    clear_near_axis(j, roots);
    return std::min_element(roots.begin(), roots.end(), further_right)->real();
}

}  // namespace stickslip
