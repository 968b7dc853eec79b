#include "analysis/stability/delay_spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "analysis/numerics/balance.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/joint_spectrum.h"

namespace stickslip {
namespace {

/// Values at the nodes t_k = −T (1 − cos(πk/n))/2, k = 0 … n, represent a function on [−T, 0].
class ChebyshevHistory {
  public:
    ChebyshevHistory(double duration, int intervals) : node_(intervals + 1), weight_(intervals + 1)
    {
        for (int k = 0; k <= intervals; ++k) {
            node_[k] = -duration * (1 - std::cos(std::numbers::pi * k / intervals)) / 2;
            weight_[k] = (k % 2 == 0 ? 1 : -1) * (k == 0 || k == intervals ? 0.5 : 1);
        }
    }
    int size() const { return static_cast<int>(node_.size()); }

    /// Weights w with p(t) = Σ w_k p(t_k), barycentric.
    Eigen::VectorXd at(double t) const
    {
        Eigen::VectorXd w = Eigen::VectorXd::Zero(size());
        for (int k = 0; k < size(); ++k) {
            if (t == node_[k]) return Eigen::VectorXd::Unit(size(), k);
            w[k] = weight_[k] / (t - node_[k]);
        }
        return w / w.sum();
    }

    /// D with p'(t_i) = Σ_k D_ik p(t_k).
    Eigen::MatrixXd derivative() const
    {
        Eigen::MatrixXd D = Eigen::MatrixXd::Zero(size(), size());
        for (int i = 0; i < size(); ++i)
            for (int k = 0; k < size(); ++k)
                if (k != i) {
                    D(i, k) = weight_[k] / weight_[i] / (node_[i] - node_[k]);
                    D(i, i) -= D(i, k);
                }
        return D;
    }

  private:
    std::vector<double> node_, weight_;
};

double memory_duration(const LinearFriction& f)
{
    double longest = f.table ? f.table->duration() : 0;
    for (const auto& d : f.delays) longest = std::max(longest, d.time);
    return longest;
}

/// Weights of the history's nodes in ∫ g(t') v(t − t') dt' for what is no state; the table by Gauss-Legendre, three
/// points a piece.
Eigen::VectorXd kernel_weights(const LinearFriction& f, const ChebyshevHistory& history)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(history.size());
    for (const auto& d : f.delays) sum += d.weight * history.at(-d.time);
    if (!f.table) return sum;
    const auto& t = f.table->time;
    const double reach = std::sqrt(0.6);
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        const double middle = (t[k] + t[k + 1]) / 2, half = (t[k + 1] - t[k]) / 2;
        for (const double x : {-reach, 0.0, reach}) {
            const double at = middle + half * x, weight = half * (x == 0 ? 8.0 / 9 : 5.0 / 9);
            sum += f.table_scale * weight * f.table->at(at) * history.at(-at);
        }
    }
    return sum;
}

/// The state matrix with the history of every remembering body appended; node 0 of a history is the body's own
/// velocity.
Eigen::MatrixXd extended_matrix(const LinearJoint& j)
{
    const double fastest = frequency_bound(j, std::abs(j.k_p));
    Eigen::MatrixXd A = state_matrix(j);
    for (int i = 0; i < j.bodies; ++i) {
        const auto& f = j.friction[i];
        const double duration = memory_duration(f);
        if (duration == 0) continue;
        const ChebyshevHistory history(duration,
                                       static_cast<int>(std::clamp(20 + 0.7 * fastest * duration, 30.0, 200.0)));
        const Eigen::MatrixXd D = history.derivative();
        const Eigen::VectorXd w = kernel_weights(f, history);
        const Eigen::Index size = A.rows(), nodes = history.size() - 1, v = j.bodies + i;
        Eigen::MatrixXd larger = Eigen::MatrixXd::Zero(size + nodes, size + nodes);
        larger.topLeftCorner(size, size) = A;
        larger(v, v) += w[0] / j.inertia[i];
        larger.block(v, size, 1, nodes) += w.tail(nodes).transpose() / j.inertia[i];
        larger.block(size, v, nodes, 1) = D.col(0).tail(nodes);
        larger.block(size, size, nodes, nodes) = D.bottomRightCorner(nodes, nodes);
        A = larger;
    }
    return A;
}

}  // namespace

std::vector<Complex> rightmost_roots(const LinearJoint& j)
{
    Eigen::MatrixXd A = extended_matrix(j);
    if (!A.allFinite()) return {};
    balance(A);
    const Eigen::VectorXcd values = A.eigenvalues();
    std::vector<Complex> starts(values.begin(), values.end()), roots;
    std::sort(starts.begin(), starts.end(), [](const Complex& a, const Complex& b) { return a.real() > b.real(); });
    constexpr std::size_t most = 40;
    for (const Complex& start : starts) {
        if (roots.size() >= most) break;
        Complex s = start, step = 0;
        for (int i = 0; i < 30; ++i) {
            const auto F = closed_loop(j, s);
            step = F.value / F.slope;
            s -= step;
            // eigenvalues that the nodes do not resolve wander off: only what stays near is a root
            if (!(std::abs(step) > 1e-15 * std::abs(s)) || !(std::abs(s - start) < 0.1 * std::abs(start))) break;
        }
        if (!(std::abs(step) < 1e-9 * std::abs(s)) || !(std::abs(s - start) < 0.1 * std::abs(start))) continue;
        const bool known = std::any_of(roots.begin(), roots.end(),
                                       [&](const Complex& r) { return std::abs(r - s) < 1e-8 * std::abs(s); });
        if (!known) roots.push_back(s);
    }
    return roots;
}

double confirmed_abscissa(const LinearJoint& j, const std::vector<Complex>& roots)
{
    double pole = -infinity;  // G has no meaning further left
    for (int i = 0; i < j.bodies; ++i)
        for (int k = 0; k < j.friction[i].states; ++k) pole = std::max(pole, j.friction[i].lambda[k]);
    const auto clear = [&](double sigma) {
        const auto count = roots_right_of(j, sigma);
        return count && *count == 0;
    };
    if (!roots.empty()) {
        const double largest = roots.front().real(), margin = 1e-6 * std::abs(roots.front());
        if (largest <= pole || clear(largest + margin)) return largest;
    }
    double high = frequency_bound(j, std::abs(j.k_p)), low = std::isfinite(pole) ? 0.999 * pole : -high;
    if (!std::isfinite(high) || !clear(high)) return missing;
    while (high - low > 1e-9 * (std::abs(high) + std::abs(low))) {
        const double middle = (low + high) / 2;
        (clear(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace stickslip
