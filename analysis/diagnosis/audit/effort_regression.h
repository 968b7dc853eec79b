// What a controller could have made a measured effort of, by least squares, where no limit cut it off.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace stickslip::gap {

/// What a controller could have made its effort of, one row an entry.
struct EffortTerms {
    std::vector<double> error, integral, velocity, rate, acceleration, documented, added, effort;
};

/// Least squares of the effort on some columns, `late` rows before it.
class EffortRegression {
  public:
    using Columns = std::vector<const std::vector<double>*>;
    EffortRegression(const EffortTerms& terms, Columns columns, bool constant, std::size_t late);

    /// Whether enough rows are known to be no limit.
    bool solved() const { return x_.size() > 0; }
    /// Part of the squares of these rows.
    double left() const { return left_; }
    const Eigen::VectorXd& numbers() const { return x_; }

  private:
    Eigen::VectorXd at(std::size_t row) const;
    void fit(const std::vector<char>& taken);

    const EffortTerms& terms_;
    Columns columns_;
    bool constant_;
    std::size_t late_;
    double left_ = 1;
    Eigen::VectorXd x_;
};

}  // namespace stickslip::gap
