#include "analysis/stability/spectrum.h"

#include <Eigen/Dense>
#include <algorithm>

#include "analysis/numerics/eigenvalues.h"
#include "analysis/numerics/polynomial.h"
#include "analysis/stability/critical_gain.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/polished.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// (27) for no state: m s² + C s + k_p.
auto roots_without_state(const LinearMass& j)
{
    return quadratic_roots((j.k_v + j.friction.f_v) / j.inertia, j.k_p / j.inertia);
}

/// (27) times (s − λ): m s³ + (C − mλ) s² + (k_p − Cλ + h b) s − k_p λ.
auto roots_with_one_state(const LinearMass& j)
{
    const double C = j.k_v + j.friction.f_v, lambda = j.friction.lambda[0];
    return cubic_roots(C / j.inertia - lambda, (j.k_p - C * lambda - j.friction.weight(0)) / j.inertia,
                       -j.k_p * lambda / j.inertia);
}

/// d log/ds of F(s) Π(s − λ), (27) times what makes it entire: beside a pole whose weight is next to nothing F alone
/// would lead away.
Complex drift(const LinearMass& j, Complex s)
{
    Complex G = 0, G_slope = 0, from_poles = 0;
    for (int k = 0; k < j.friction.states; ++k) {
        const Complex gap = s - j.friction.lambda[k];
        G += j.friction.weight(k) / gap;
        G_slope -= j.friction.weight(k) / (gap * gap);
        from_poles += 1.0 / gap;
    }
    const Complex C = j.k_v + j.friction.f_v - G;
    const Complex value = (j.inertia * s + C) * s + j.k_p;
    const Complex slope = 2 * j.inertia * s + C - G_slope * s;
    return slope / value + from_poles;
}

/// States (x, v, θ_i): v' = −(k_p x + C v + Σ h θ)/m, θ_i' = b_i v + λ_i θ_i.
std::vector<Complex> roots_of_matrix(const LinearMass& j)
{
    const int n = 2 + j.friction.states;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    A(0, 1) = 1;
    A(1, 0) = -j.k_p / j.inertia;
    A(1, 1) = -(j.k_v + j.friction.f_v) / j.inertia;
    for (int i = 0; i < j.friction.states; ++i) {
        A(1, 2 + i) = -j.friction.h[i] / j.inertia;
        A(2 + i, 1) = j.friction.b[i];
        A(2 + i, 2 + i) = j.friction.lambda[i];
    }
    Eigen::VectorXcd values = eigenvalues_of(A);
    if (values.size() == 0) return {};
    std::vector<Complex> roots;
    if (j.k_p == 0) {
        // nothing holds the position: one root is 0, and only its rounding comes out of the matrix
        Eigen::Index least = 0;
        values.cwiseAbs().minCoeff(&least);
        values[least] = 0;
    }
    for (const auto& s : values) roots.push_back(polished(s, [&](Complex z) { return drift(j, z); }));
    return roots;
}

/// side_of_axis, but where rounding decides there and the closed form of the critical gain does not leave it in doubt,
/// the side that it says: at gains far beyond any machine the decay of the oscillation is below its own rounding.
double decided_side(const LinearMass& mass, Complex s)
{
    const double side = side_of_axis(mass, s);
    if (side != 0 || mass.friction.states != 1 || s.imag() == 0) return side;
    const auto critical = critical_gain(mass.inertia, mass.k_v, mass.friction);
    // k_cr is worth as many digits fewer as B − A − k_v V_0 loses
    const double C = mass.k_v + mass.friction.f_v, weight = mass.friction.weight(0);
    const double clear = 1e-9 / std::min(1.0, std::abs(1 + C * mass.friction.lambda[0] / weight));
    if (!critical || !(std::abs(mass.k_p / critical->k_p - 1) > clear)) return side;
    // the oscillation of an ever stiffer spring decays by what damps it at once, (28)
    return mass.k_p > critical->k_p ? -C / (2 * mass.inertia) : std::numeric_limits<double>::min();
}

template <class Roots>
double largest_real_part(const LinearMass& mass, const Roots& roots)
{
    double largest = -infinity;
    for (const auto& s : roots) {
        if (std::isnan(s.real())) return not_set;
        largest = std::max(largest, decided_side(mass, s));
    }
    return largest == -infinity ? not_set : largest;
}

}  // namespace

std::vector<Complex> spectrum(const LinearMass& mass)
{
    std::vector<Complex> roots;
    if (mass.friction.states == 0) {
        const auto r = roots_without_state(mass);
        roots.assign(r.begin(), r.end());
    } else if (mass.friction.states == 1) {
        const auto r = roots_with_one_state(mass);
        roots.assign(r.begin(), r.end());
    } else {
        roots = roots_of_matrix(mass);
    }
    for (auto& s : roots) s.real(decided_side(mass, s));
    std::sort(roots.begin(), roots.end(), [](const Complex& a, const Complex& b) {
        return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
    });
    return roots;
}

double spectral_abscissa(const LinearMass& mass)
{
    if (mass.friction.states == 0) return largest_real_part(mass, roots_without_state(mass));
    if (mass.friction.states == 1) return largest_real_part(mass, roots_with_one_state(mass));
    return largest_real_part(mass, roots_of_matrix(mass));
}

}  // namespace stickslip
