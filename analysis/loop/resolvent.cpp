#include "analysis/loop/resolvent.h"

#include <Eigen/Dense>
#include <array>

#include "analysis/numerics/balance.h"
#include "analysis/numerics/quotient.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// Room for the states of a loop: on the stack where they fit.
template <class T>
class Column {
  public:
    explicit Column(Eigen::Index size)
    {
        if (size > few) many_.resize(static_cast<std::size_t>(size));
        data_ = size > few ? many_.data() : some_.data();
    }
    Column(const Column&) = delete;
    Column& operator=(const Column&) = delete;
    T& operator[](Eigen::Index i) { return data_[i]; }

  private:
    static constexpr Eigen::Index few = 32;
    std::array<T, few> some_;
    std::vector<T> many_;
    T* data_;
};

}  // namespace

Resolvent::Resolvent(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows)
{
    const auto n = A.rows();
    Eigen::VectorXd units = Eigen::VectorXd::Ones(n);
    Eigen::MatrixXd balanced = A;
    balance(balanced, &units);
    Eigen::VectorXd in = input.cwiseQuotient(units);
    Eigen::MatrixXd read = rows * units.asDiagonal();
    size_ = in.norm();
    if (n == 0 || !(size_ > 0)) {
        read_ = Eigen::MatrixXd::Zero(rows.rows(), 0);
        return;
    }
    // Householder's reflection that turns the input onto the first axis
    Eigen::VectorXd mirror = in / size_;
    const double sign = mirror[0] > 0 ? -1 : 1;
    mirror[0] -= sign;
    const double square = mirror.squaredNorm();
    if (square > 0) {
        balanced -= (2 / square) * mirror * (mirror.transpose() * balanced).eval();
        balanced -= (2 / square) * (balanced * mirror).eval() * mirror.transpose();
        read -= (2 / square) * (read * mirror).eval() * mirror.transpose();
    }
    size_ *= sign;
    if (n > 2) {
        const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(balanced);
        hessenberg_ = reduced.matrixH();
        read_ = read * Eigen::MatrixXd(reduced.matrixQ());
    } else {
        hessenberg_ = balanced;
        read_ = read;
    }
    reached_ = 1;
    while (reached_ < n && hessenberg_(reached_, reached_ - 1) != 0) ++reached_;
}

void Resolvent::at(Complex s, Complex* values) const
{
    const auto n = reached_;
    for (Eigen::Index r = 0; r < rows(); ++r) values[r] = 0;
    if (n == 0) return;
    Column<Complex> x(n);
    x[n - 1] = 1;
    Complex top = 0;
    for (Eigen::Index i = n; i-- > 0;) {
        const double* row = hessenberg_.row(i).data();
        Complex sum = (s - row[i]) * x[i];
        for (Eigen::Index k = i + 1; k < n; ++k) sum -= row[k] * x[k];
        if (i > 0)
            x[i - 1] = sum / row[i - 1];
        else
            top = sum;
    }
    for (Eigen::Index r = 0; r < rows(); ++r) {
        Complex sum = 0;
        for (Eigen::Index k = 0; k < n; ++k) sum += read_(r, k) * x[k];
        values[r] = quotient(size_ * sum, top);
    }
}

void Resolvent::at(Complex s, Response* values) const
{
    const auto n = reached_;
    for (Eigen::Index r = 0; r < rows(); ++r) values[r] = {};
    if (n == 0) return;
    Column<Complex> x(n), slope(n);
    x[n - 1] = 1, slope[n - 1] = 0;
    Complex top = 0, top_slope = 0;
    for (Eigen::Index i = n; i-- > 0;) {
        const double* row = hessenberg_.row(i).data();
        const Complex own = s - row[i];
        Complex sum = own * x[i], rate = x[i] + own * slope[i];
        for (Eigen::Index k = i + 1; k < n; ++k) {
            sum -= row[k] * x[k];
            rate -= row[k] * slope[k];
        }
        if (i > 0) {
            x[i - 1] = sum / row[i - 1];
            slope[i - 1] = rate / row[i - 1];
        } else {
            top = sum, top_slope = rate;
        }
    }
    for (Eigen::Index r = 0; r < rows(); ++r) {
        Complex sum = 0, rate = 0;
        for (Eigen::Index k = 0; k < n; ++k) {
            sum += read_(r, k) * x[k];
            rate += read_(r, k) * slope[k];
        }
        const Complex value = quotient(sum, top);
        values[r] = {size_ * value, quotient(size_ * (rate - value * top_slope), top)};
    }
}

}  // namespace stickslip
