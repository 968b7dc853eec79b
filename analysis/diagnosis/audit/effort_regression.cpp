#include "analysis/diagnosis/audit/effort_regression.h"

#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/results/point.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace stickslip::gap {

EffortRegression::EffortRegression(const EffortTerms& terms, Columns columns, bool constant, std::size_t late)
    : terms_(terms), columns_(std::move(columns)), constant_(constant), late_(late)
{
    // what a controller wants beyond its limit does not come out. The middle of the range is no limit; which of the
    // other rows are none is told by what this fit wants in them, since a controller makes noise of its own
    constexpr double inner = 0.5;  // numerical: of the range
    const auto [least, largest] = std::minmax_element(terms.effort.begin(), terms.effort.end());
    const double middle = 0.5 * (*least + *largest), half = 0.5 * (*largest - *least);
    const std::size_t rows = terms.effort.size();
    std::vector<char> taken(rows);
    for (std::size_t k = late_; k < rows; ++k) taken[k] = std::abs(terms.effort[k] - middle) < inner * half;
    fit(taken);
    if (!solved()) return;
    std::vector<double> wanted(rows), missed(rows, missing);
    for (std::size_t k = late_; k < rows; ++k) {
        wanted[k] = at(k).dot(x_);
        if (taken[k]) missed[k] = terms.effort[k] - wanted[k];
    }
    const double below = policy::below_limit * (half - policy::scatter_at_limit * noise_of(missed));
    if (!(below > inner * half)) return;
    for (std::size_t k = late_; k < rows; ++k) taken[k] = std::abs(wanted[k] - middle) < below;
    fit(taken);
}

Eigen::VectorXd EffortRegression::at(std::size_t row) const
{
    const auto count = static_cast<Eigen::Index>(columns_.size());
    Eigen::VectorXd values = Eigen::VectorXd::Ones(count + (constant_ ? 1 : 0));
    for (Eigen::Index i = 0; i < count; ++i) values[i] = (*columns_[static_cast<std::size_t>(i)])[row - late_];
    return values;
}

void EffortRegression::fit(const std::vector<char>& taken)
{
    std::vector<std::size_t> rows;
    for (std::size_t k = late_; k < taken.size(); ++k)
        if (taken[k]) rows.push_back(k);
    const auto n = static_cast<Eigen::Index>(rows.size());
    const auto m = static_cast<Eigen::Index>(columns_.size()) + (constant_ ? 1 : 0);
    if (n <= m) return;
    Eigen::MatrixXd a(n, m);
    Eigen::VectorXd b(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        a.row(i) = at(rows[static_cast<std::size_t>(i)]);
        b[i] = terms_.effort[rows[static_cast<std::size_t>(i)]];
    }
    x_ = a.colPivHouseholderQr().solve(b);
    left_ = b.squaredNorm() > 0 ? (b - a * x_).squaredNorm() / b.squaredNorm() : 0;
}

}  // namespace stickslip::gap
