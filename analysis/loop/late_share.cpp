#include "analysis/loop/late_share.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace stickslip {
namespace {

using Complex = std::complex<double>;

Eigen::MatrixXd with_speeds(const Eigen::MatrixXd& rows, const std::vector<LateFriction>& friction)
{
    Eigen::MatrixXd all(rows.rows() + static_cast<Eigen::Index>(friction.size()), rows.cols());
    all.topRows(rows.rows()) = rows;
    for (std::size_t i = 0; i < friction.size(); ++i)
        all.row(rows.rows() + static_cast<Eigen::Index>(i)) = friction[i].speed;
    return all;
}

constexpr std::size_t most_late = 4;  ///< bodies

}  // namespace

LateShare::LateShare(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows,
                     const std::vector<LateFriction>& friction)
    : friction_(friction), rows_(rows.rows()), by_input_(A, input, with_speeds(rows, friction))
{
    for (const auto& f : friction_) by_push_.emplace_back(A, f.push, with_speeds(rows, friction_));
}

void LateShare::at(Complex s, bool once, Complex* added) const
{
    const auto m = static_cast<Eigen::Index>(friction_.size());
    std::array<Complex, 4 + most_late> values;
    by_input_.at(s, values.data());
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, most_late, most_late> closed(m, m);
    Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, most_late, 1> force(m);
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, 4, most_late> by_force(rows_, m);
    std::array<Complex, most_late> answer, first{};
    for (Eigen::Index i = 0; i < m; ++i) {
        answer[static_cast<std::size_t>(i)] = friction_[static_cast<std::size_t>(i)].answer(s);
        force[i] = answer[static_cast<std::size_t>(i)] * values[static_cast<std::size_t>(rows_ + i)];
        if (once) continue;
        Complex sum = 0;
        for (const auto& d : friction_[static_cast<std::size_t>(i)].delays) sum += d.weight * std::exp(-s * d.time);
        first[static_cast<std::size_t>(i)] = sum * values[static_cast<std::size_t>(rows_ + i)];
    }
    for (Eigen::Index k = 0; k < m; ++k) {
        by_push_[static_cast<std::size_t>(k)].at(s, values.data());
        for (Eigen::Index r = 0; r < rows_; ++r) by_force(r, k) = values[static_cast<std::size_t>(r)];
        for (Eigen::Index i = 0; i < m; ++i)
            closed(i, k) = (i == k ? 1.0 : 0.0) -
                           answer[static_cast<std::size_t>(i)] * values[static_cast<std::size_t>(rows_ + i)];
    }
    if (m == 1)
        force[0] /= closed(0, 0);
    else
        force = closed.partialPivLu().solve(force).eval();
    for (Eigen::Index i = 0; i < m; ++i) force[i] -= first[static_cast<std::size_t>(i)];
    for (Eigen::Index r = 0; r < rows_; ++r) added[r] = (by_force.row(r) * force)(0);
}

}  // namespace stickslip
