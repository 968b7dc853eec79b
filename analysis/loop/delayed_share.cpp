#include "analysis/loop/delayed_share.h"

#include <Eigen/Dense>
#include <array>

#include "analysis/numerics/quotient.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

Eigen::MatrixXd with_speeds(const Eigen::MatrixXd& rows, const std::vector<DelayedFriction>& friction)
{
    Eigen::MatrixXd all(rows.rows() + static_cast<Eigen::Index>(friction.size()), rows.cols());
    all.topRows(rows.rows()) = rows;
    for (std::size_t i = 0; i < friction.size(); ++i)
        all.row(rows.rows() + static_cast<Eigen::Index>(i)) = friction[i].speed;
    return all;
}

}  // namespace

DelayedShare::DelayedShare(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows,
                           const std::vector<DelayedFriction>& friction)
    : friction_(friction), rows_(rows.rows()), by_input_(A, input, with_speeds(rows, friction))
{
    for (const auto& f : friction_) by_push_.emplace_back(A, f.push, with_speeds(rows, friction_));
}

void DelayedShare::at(Complex s, Complex* added) const
{
    std::array<Answer, most_delayed> answers;
    for (std::size_t i = 0; i < friction_.size(); ++i) answers[i] = {friction_[i].answer(s), 0};
    at(s, 0, answers.data(), added);
}

/// r = U' + W' U' + W'² U' + …, with U' = G U and W' = G W: (1 − W')⁻¹ U' less its first terms, of the delays alone.
void DelayedShare::at(Complex s, int early, const Answer* answers, Complex* added) const
{
    using Square = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, most_delayed, most_delayed>;
    using Column = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, most_delayed, 1>;
    const auto m = static_cast<Eigen::Index>(friction_.size());
    std::array<Complex, 4 + most_delayed> values;
    by_input_.at(s, values.data());
    Square closed(m, m), again(m, m);
    Column force(m), term(m);
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, 4, most_delayed> by_force(rows_, m);
    for (Eigen::Index i = 0; i < m; ++i) {
        const Complex speed = values[static_cast<std::size_t>(rows_ + i)];
        force[i] = answers[i].all * speed;
        term[i] = answers[i].delays * speed;
    }
    for (Eigen::Index k = 0; k < m; ++k) {
        by_push_[static_cast<std::size_t>(k)].at(s, values.data());
        for (Eigen::Index r = 0; r < rows_; ++r) by_force(r, k) = values[static_cast<std::size_t>(r)];
        for (Eigen::Index i = 0; i < m; ++i) {
            const Complex speed = values[static_cast<std::size_t>(rows_ + i)];
            closed(i, k) = (i == k ? 1.0 : 0.0) - answers[i].all * speed;
            again(i, k) = answers[i].delays * speed;
        }
    }
    if (m == 1)
        force[0] = quotient(force[0], closed(0, 0));
    else
        force = closed.partialPivLu().solve(force).eval();
    for (int k = 0; k < early; ++k) {
        force -= term;
        if (k + 1 < early) term = m == 1 ? Column(again(0, 0) * term) : Column(again * term);
    }
    for (Eigen::Index r = 0; r < rows_; ++r) added[r] = (by_force.row(r) * force)(0);
}

}  // namespace stickslip
