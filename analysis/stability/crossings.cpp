#include "analysis/stability/crossings.h"

#include <Eigen/Dense>
#include <algorithm>

#include "analysis/stability/critical_gain.h"

namespace stickslip {
namespace {

/// Σ w_i |λ_i| / (λ_i² + u) − C: (34) for the kernel Σ w_i e^{λ_i t}, u = ω².
double excess(const LinearMass& mass, double u)
{
    double sum = -(mass.k_v + mass.friction.f_v);
    for (int i = 0; i < mass.friction.states; ++i) {
        const double lambda = mass.friction.lambda[i];
        sum += mass.friction.weight(i) * -lambda / (lambda * lambda + u);
    }
    return sum;
}

double excess_slope(const LinearMass& mass, double u)
{
    double sum = 0;
    for (int i = 0; i < mass.friction.states; ++i) {
        const double lambda = mass.friction.lambda[i], square = lambda * lambda + u;
        sum -= mass.friction.weight(i) * -lambda / (square * square);
    }
    return sum;
}

/// Coefficients of C Π(λ_i² + u) − Σ w_i |λ_i| Π_{j≠i}(λ_j² + u), lowest power first, in units of u where the decay
/// rates are near one.
std::vector<double> polynomial_of(const LinearMass& mass, double unit)
{
    const auto& f = mass.friction;
    const auto product_without = [&](int left_out) {
        std::vector<double> p{1};
        for (int j = 0; j < f.states; ++j) {
            if (j == left_out) continue;
            p.push_back(0);
            for (std::size_t k = p.size() - 1; k > 0; --k) p[k] = p[k - 1] + p[k] * f.lambda[j] * f.lambda[j] / unit;
            p[0] *= f.lambda[j] * f.lambda[j] / unit;
        }
        return p;
    };
    std::vector<double> sum = product_without(-1);
    for (double& c : sum) c *= mass.k_v + f.f_v;
    for (int i = 0; i < f.states; ++i) {
        const auto part = product_without(i);
        for (std::size_t k = 0; k < part.size(); ++k) sum[k] -= f.weight(i) * -f.lambda[i] / unit * part[k];
    }
    return sum;
}

/// Roots u > 0 of (34), each polished on (34) itself.
std::vector<double> squared_frequencies(const LinearMass& mass)
{
    const auto& f = mass.friction;
    double unit = 0;
    for (int i = 0; i < f.states; ++i) unit = std::max(unit, f.lambda[i] * f.lambda[i]);
    if (!(unit > 0) || !std::isfinite(unit)) return {};
    auto p = polynomial_of(mass, unit);
    while (!p.empty() && p.back() == 0) p.pop_back();
    if (p.size() < 2) return {};
    const auto degree = static_cast<Eigen::Index>(p.size() - 1);
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
    if (degree > 1) companion.diagonal(-1).setOnes();
    for (Eigen::Index k = 0; k < degree; ++k) companion(k, degree - 1) = -p[static_cast<std::size_t>(k)] / p.back();
    if (!companion.allFinite()) return {};
    std::vector<double> roots;
    for (const auto& root : Eigen::VectorXcd(companion.eigenvalues())) {
        double u = root.real() * unit;
        if (std::abs(root.imag()) > 1e-6 * std::abs(root) || !(u > 0)) continue;
        for (int i = 0; i < 4; ++i) {
            const double step = excess(mass, u) / excess_slope(mass, u);
            if (!(std::abs(step) < 0.1 * u)) break;
            u -= step;
        }
        roots.push_back(u);
    }
    return roots;
}

/// (35): k_p = m ω² + ω ∫g sin ωt dt = u (m + Σ w_i/(λ_i² + u)).
double gain_at(const LinearMass& mass, double u)
{
    double sum = mass.inertia;
    for (int i = 0; i < mass.friction.states; ++i)
        sum += mass.friction.weight(i) / (mass.friction.lambda[i] * mass.friction.lambda[i] + u);
    return u * sum;
}

}  // namespace

namespace {

/// One state that feeds the motion, and damping beside it: a closed form decides.
bool usual(const LinearMass& mass)
{
    return mass.friction.states == 1 && mass.k_v + mass.friction.f_v > 0 && mass.friction.weight(0) > 0;
}

}  // namespace

std::vector<Crossing> crossings(const LinearMass& mass)
{
    std::vector<Crossing> found;
    if (usual(mass)) {
        // with C > 0 and a positive kernel a rising gain turns the joint stable: (28)
        if (const auto critical = critical_gain(mass.inertia, mass.k_v, mass.friction))
            found.push_back({critical->k_p, critical->omega, -1});
    } else {
        for (const double u : squared_frequencies(mass)) {
            const double k_p = gain_at(mass, u);
            // dk_p > 0 moves the root by −1/F'(iω), whose real part has the sign of −Re F' = −(C − Re G − ω Im G') = ω
            // Im G' and Im G'(iω) has the sign of Σ w λ/(λ² + ω²)², that is of d(excess)/du
            if (k_p > 0) found.push_back({k_p, std::sqrt(u), excess_slope(mass, u) > 0 ? 1 : -1});
        }
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

std::vector<Interval> stable_intervals(const LinearMass& mass, const std::vector<Crossing>& crossings)
{
    if (usual(mass) && crossings.size() == 1) return {{crossings[0].k_p, infinity}};
    std::vector<double> bounds{0};
    for (const auto& c : crossings) bounds.push_back(c.k_p);
    bounds.push_back(infinity);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        LinearMass probe = mass;
        const double low = bounds[i], high = bounds[i + 1];
        const double natural = std::max(std::abs(mass.k_p), 1.0);
        probe.k_p = low == 0 && high == infinity ? natural
                    : high == infinity           ? 2 * low
                    : low == 0                   ? high / 2
                                                 : std::sqrt(low * high);
        if (mass.k_p > low && mass.k_p < high) probe.k_p = mass.k_p;
        if (!(spectral_abscissa(probe) < 0)) continue;
        if (!intervals.empty() && intervals.back().high == low)
            intervals.back().high = high;
        else
            intervals.push_back({low, high});
    }
    return intervals;
}

}  // namespace stickslip
