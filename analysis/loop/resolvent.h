// rows (s − A)⁻¹ input at many s: what a search over frequencies asks of a loop again and again.
#pragma once
#include <Eigen/Core>
#include <complex>
#include <vector>

namespace stickslip {

/// A value and its derivative by s.
struct Response {
    std::complex<double> value, slope;
};

/// A is balanced and brought to Hessenberg form once, the input along its first axis; each s then costs one
/// back-substitution (Hyman's method: Wilkinson, The Algebraic Eigenvalue Problem, 1965, §7.11). Directions that the
/// input does not reach drop out.
class Resolvent {
  public:
    /// `rows` are read at once: k × n.
    Resolvent(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows);

    Eigen::Index rows() const { return read_.rows(); }
    /// One value a row, into `values`.
    void at(std::complex<double> s, std::complex<double>* values) const;
    void at(std::complex<double> s, Response* values) const;

  private:
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> hessenberg_, read_;
    double size_ = 0;  ///< of the input
    Eigen::Index reached_ = 0;
};

}  // namespace stickslip
