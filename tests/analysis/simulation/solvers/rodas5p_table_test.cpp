// The coefficients of Rodas5P against the order conditions of Rosenbrock methods (Hairer & Wanner, Solving ODEs II,
// Theorem IV.7.4 ff.): for every rooted tree of order p, Σ b_i Φ_i(tree) = 1/γ(tree).
#include "analysis/simulation/solvers/rodas5p_table.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
namespace table = stickslip::rodas5p;

struct Tree {
    std::vector<Tree> children;
    int order() const
    {
        int n = 1;
        for (const auto& c : children) n += c.order();
        return n;
    }
    double density() const
    {
        double product = order();
        for (const auto& c : children) product *= c.density();
        return product;
    }
};

/// All multisets of trees with `total` vertices, each tree no larger in the enumeration than `limit`.
void forests(int total, std::size_t limit, const std::vector<Tree>& known, std::vector<Tree> chosen,
             std::vector<Tree>& out)
{
    if (total == 0) out.push_back(Tree{chosen});
    for (std::size_t i = 0; i < limit; ++i) {
        if (known[i].order() > total) continue;
        auto more = chosen;
        more.push_back(known[i]);
        forests(total - known[i].order(), i + 1, known, more, out);
    }
}

std::vector<Tree> trees_up_to(int order)
{
    std::vector<Tree> all;
    for (int n = 1; n <= order; ++n) {
        std::vector<Tree> grown;
        forests(n - 1, all.size(), all, {}, grown);
        all.insert(all.end(), grown.begin(), grown.end());
    }
    return all;
}

struct Method {
    MatrixXd alpha, beta, gamma;
    VectorXd from_U(const VectorXd& weights) const { return gamma.transpose() * weights; }
};

/// Γ⁻¹ = I/γ − (c_ij), (α_ij) = (a_ij) Γ, β = α + Γ.
Method method()
{
    const int s = table::stages;
    MatrixXd a(s, s), inverse = MatrixXd::Identity(s, s) / table::gamma;
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s; ++j) {
            a(i, j) = table::a[i][j];
            inverse(i, j) -= table::c[i][j];
        }
    Method m;
    m.gamma = inverse.inverse();
    m.alpha = a * m.gamma;
    m.beta = m.alpha + m.gamma;
    return m;
}

/// Φ_i(tree): α where a vertex has several branches, β where it has one.
VectorXd weight(const Method& m, const Tree& tree)
{
    VectorXd product = VectorXd::Ones(table::stages);
    const MatrixXd& coupling = tree.children.size() == 1 ? m.beta : m.alpha;
    for (const auto& child : tree.children) product = product.cwiseProduct(coupling * weight(m, child));
    return product;
}

VectorXd step_weights(bool with_last)
{
    VectorXd w(table::stages);
    for (int j = 0; j < table::stages; ++j) w[j] = table::a[table::stages - 1][j];
    if (with_last) w[table::stages - 1] = 1;
    return w;
}

double defect(const Method& m, const VectorXd& weights_of_U, int order, double fraction = 1)
{
    double largest = 0;
    for (const auto& tree : trees_up_to(order)) {
        const double sum = m.from_U(weights_of_U).dot(weight(m, tree));
        largest = std::max(largest, std::abs(sum - std::pow(fraction, tree.order()) / tree.density()));
    }
    return largest;
}

}  // namespace

TEST_CASE("trees: 1, 1, 2, 4, 9 of orders 1 to 5")
{
    CHECK(trees_up_to(4).size() == 8);
    CHECK(trees_up_to(5).size() == 17);
}

TEST_CASE("Rodas5P: order 5, embedded order 4, dense output of order 4")
{
    const auto m = method();
    CHECK(defect(m, step_weights(true), 5) < 2e-13);
    CHECK(defect(m, step_weights(true), 6) > 1e-6);
    CHECK(defect(m, step_weights(false), 4) < 2e-13);
    CHECK(defect(m, step_weights(false), 5) > 1e-6);
    for (const double xi : {0.1, 0.37, 0.5, 0.9}) {
        VectorXd k[3] = {VectorXd(table::stages), VectorXd(table::stages), VectorXd(table::stages)};
        for (int r = 0; r < 3; ++r)
            for (int j = 0; j < table::stages; ++j) k[r][j] = table::dense[r][j];
        const VectorXd w = xi * (step_weights(true) + (1 - xi) * (k[0] + xi * (k[1] + xi * k[2])));
        CHECK(defect(m, w, 4, xi) < 1e-10);
    }
}

TEST_CASE("Rodas5P: stiffly accurate, every stage with the same γ, nodes of the paper")
{
    const auto m = method();
    const VectorXd b = m.from_U(step_weights(true));
    for (int j = 0; j < table::stages; ++j) {
        CHECK(b[j] == Approx(m.beta(table::stages - 1, j)).margin(1e-13));  // b_j = β_8j
        CHECK(m.gamma(j, j) == Approx(table::gamma).epsilon(1e-14));
    }
    CHECK(m.alpha.row(7).sum() == Approx(1).epsilon(1e-13));
}
