// The Hopf point of a flow and its first Lyapunov coefficient.
#include "analysis/simulation/attractor/bifurcation.h"

#include <cmath>
#include <complex>

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using RealMatrix = Eigen::MatrixXd;
using RealVector = Eigen::VectorXd;
using ComplexVector = Eigen::VectorXcd;

/// The Jacobian in units of the flow's scale, at steady sliding plus a scaled displacement.
class ScaledJacobian {
  public:
    explicit ScaledJacobian(const Flow& flow) : flow_(flow), steady_(flow.steady()), scale_(flow.scale()) {}
    RealMatrix operator()(const RealVector& displacement) const
    {
        FlowMatrix J;
        flow_.jacobian(steady_ + scale_.cwiseProduct(FlowVector(displacement)), J);
        return scale_.cwiseInverse().asDiagonal() * J * scale_.asDiagonal();
    }
    /// Σ_jk ∂²F/∂y_j∂y_k u_j (·)_k as a matrix, for real u.
    RealMatrix first_difference(const RealVector& u) const
    {
        constexpr double h = 1e-5;
        return ((*this)(h * u) - (*this)(-h * u)) / (2 * h);
    }
    /// Σ ∂³F/∂y_j∂y_k∂y_l u_j u_k (·)_l.
    RealMatrix second_difference(const RealVector& u) const
    {
        constexpr double h = 2e-4;
        const RealVector none = RealVector::Zero(u.size());
        return ((*this)(h * u) - 2 * (*this)(none) + (*this)(-h * u)) / (h * h);
    }
    /// B(u, v) for complex arguments.
    ComplexVector B(const ComplexVector& u, const ComplexVector& v) const
    {
        return first_difference(u.real()).cast<Complex>() * v +
               Complex(0, 1) * (first_difference(u.imag()).cast<Complex>() * v);
    }

  private:
    const Flow& flow_;
    FlowVector steady_, scale_;
};

}  // namespace

HopfPoint hopf_point(const Flow& flow)
{
    const ScaledJacobian J(flow);
    const int n = flow.size();
    const RealVector none = RealVector::Zero(n);
    const RealMatrix A = J(none);
    const Eigen::EigenSolver<RealMatrix> right(A), left(A.transpose());
    const auto critical = [n](const Eigen::EigenSolver<RealMatrix>& solver) {
        Eigen::Index best = -1;
        for (Eigen::Index i = 0; i < n; ++i) {
            const Complex s = solver.eigenvalues()[i];
            if (s.imag() > 0 && (best < 0 || std::abs(s.real()) < std::abs(solver.eigenvalues()[best].real())))
                best = i;
        }
        return best;
    };
    HopfPoint point;
    const Eigen::Index r = critical(right), l = critical(left);
    if (r < 0 || l < 0) return point;
    point.k_p = flow.gain();
    point.omega = right.eigenvalues()[r].imag();
    const FlowVector scale = flow.scale(), gradient = flow.speed_gradient(flow.steady()).cwiseProduct(scale);
    ComplexVector q = right.eigenvectors().col(r);
    q /= 2.0 * (gradient.cast<Complex>().transpose() * q)(0);  // y = 2 Re(z q) then has |z| as its amplitude of ln V
    ComplexVector p = left.eigenvectors().col(l).conjugate();  // A^T p = −iω p
    p /= std::conj(Complex(p.dot(q)));                         // ⟨p, q⟩ = Σ p̄ q = 1

    const RealVector a = q.real(), b = q.imag();
    const RealMatrix Daa = J.second_difference(a), Dbb = J.second_difference(b);
    // C(q, q, q̄) = C(a,a,a) + C(a,b,b) + i (C(a,a,b) + C(b,b,b))
    const ComplexVector C = (Daa * a + Dbb * a).cast<Complex>() + Complex(0, 1) * (Daa * b + Dbb * b).cast<Complex>();
    const ComplexVector mean = A.cast<Complex>().partialPivLu().solve(J.B(q, q.conjugate()));
    const Eigen::MatrixXcd second =
        2.0 * Complex(0, point.omega) * Eigen::MatrixXcd::Identity(n, n) - A.cast<Complex>();
    const ComplexVector doubled = second.partialPivLu().solve(J.B(q, q));
    const Complex sum = p.dot(C) - 2.0 * p.dot(J.B(q, mean)) + p.dot(J.B(q.conjugate(), doubled));
    point.lyapunov = 0.5 * sum.real();

    const ComplexVector physical = scale.cast<Complex>().cwiseProduct(q);
    point.direction = (physical / physical[0]).real();
    return point;
}

}  // namespace stickslip
