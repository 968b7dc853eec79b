#include "analysis/numerics/eigenvalues.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <complex>

using namespace stickslip;
using Complex = std::complex<double>;

// A mass on a stiff spring, its position behind a filter, a friction state that nothing drives, and an integrator of
// the filtered position: beside 1e5 rad/s, rounding of a whole decomposition is worth 1e-11.
TEST_CASE("eigenvalues of states that are coupled one way stand on the diagonal to the last digit", "[numerics]")
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(5, 5);
    A(0, 1) = 1;                    // position
    A(1, 0) = -1e10, A(1, 1) = -3;  // velocity
    A(1, 2) = 7e4, A(2, 2) = -8.25663728822;
    A(3, 0) = 648.183, A(3, 3) = -648.183;
    A(4, 3) = 1;
    const Eigen::VectorXcd values = eigenvalues_of(A);
    for (const double exact : {-8.25663728822, -648.183, 0.0})
        CHECK(std::count(values.begin(), values.end(), Complex(exact)) == 1);
    const Complex oscillation(-1.5, std::sqrt(1e10 - 2.25));
    for (const Complex& s : {oscillation, std::conj(oscillation)})
        CHECK(
            std::any_of(values.begin(), values.end(), [&](Complex v) { return std::abs(v - s) < 1e-9 * std::abs(s); }));
}
