#include "analysis/diagnosis/outcomes/law_cost.h"

#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

double log_probability(double p, bool stick_slip)
{
    return std::log(stick_slip ? p : 1 - p);
}

std::vector<double> distances(const Outcomes& o, const FrictionLaw& law, const std::vector<std::size_t>& rows)
{
    std::vector<double> d;
    for (std::size_t i : rows) {
        if (o.checkpoint) o.checkpoint();
        d.push_back(distance_to_stick_slip(with_law(o.joints[i], law)));
    }
    return d;
}

std::vector<std::size_t> all_rows(const Outcomes& o)
{
    std::vector<std::size_t> rows(o.size());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    return rows;
}

double cost(const Outcomes& o, const RivalLaw& rival, const std::vector<std::size_t>& rows,
            const std::vector<double>& x)
{
    const auto d = distances(o, rival.make(o.scales, x.data()), rows);
    const double softness = std::exp(x.back());
    double sum = 0;
    for (std::size_t k = 0; k < rows.size(); ++k)
        sum -= log_probability(probability_at(d[k], softness), o.table.rows[rows[k]].stick_slip);
    for (std::size_t i = 0; i < rival.numbers.size(); ++i) {
        const double half = (rival.numbers[i].high - rival.numbers[i].low) / 2;
        const double away = (x[i] - rival.numbers[i].low) / half - 1;
        sum += 0.5 * away * away;
    }
    return sum;
}

std::vector<double> standard_errors(const Outcomes& o, const RivalLaw& rival, const std::vector<double>& x)
{
    const auto rows = all_rows(o);
    const auto n = static_cast<Eigen::Index>(x.size());
    const auto at = [&](Eigen::Index i, double a, Eigen::Index j, double b) {
        auto y = x;
        y[static_cast<std::size_t>(i)] += a;
        y[static_cast<std::size_t>(j)] += b;
        return cost(o, rival, rows, y);
    };
    constexpr double h = 0.05;  // numerical: log units: wide enough to average over single rows
    Eigen::MatrixXd curvature(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            curvature(i, j) = curvature(j, i) =
                (at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h)) / (4 * h * h);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(curvature);
    Eigen::VectorXd variance = eigen.eigenvalues();
    constexpr double flattest = 0.04;  // numerical: a standard deviation of 5 in a logarithm: not determined
    for (auto& v : variance) v = 1 / std::max(v, flattest);
    const Eigen::MatrixXd covariance = eigen.eigenvectors() * variance.asDiagonal() * eigen.eigenvectors().transpose();
    const auto middle = rival.values(rival.make(o.scales, x.data()));
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(middle.size()), n);
    for (Eigen::Index j = 0; j < n; ++j) {
        auto y = x;
        y[static_cast<std::size_t>(j)] += 1e-5;
        const auto moved = rival.values(rival.make(o.scales, y.data()));
        for (std::size_t i = 0; i < middle.size(); ++i)
            jacobian(static_cast<Eigen::Index>(i), j) = (moved[i] - middle[i]) / 1e-5;
    }
    const Eigen::VectorXd squares = (jacobian * covariance * jacobian.transpose()).diagonal();
    std::vector<double> errors;
    for (double s : squares) errors.push_back(std::sqrt(s));
    return errors;
}

void judge(const Outcomes& o, LawFit& fit)
{
    fit.held_out = 0, fit.misjudged = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
        const bool stick_slip = o.table.rows[i].stick_slip;
        fit.held_out += log_probability(fit.probability[i], stick_slip);
        fit.misjudged += (fit.probability[i] > policy::likelier_than_not) != stick_slip;
    }
}

}  // namespace stickslip::gap
