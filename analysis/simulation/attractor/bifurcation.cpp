// In one file: one branch of cycles, from its Hopf point to its fold.
#include "analysis/simulation/attractor/bifurcation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>

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

/// One amplitude on the branch: what is left of a closed orbit, and how that depends on the states and the gain.
struct Closure {
    RealVector gap;
    RealMatrix by_unknowns;
};

/// Unknowns are y[2…] and ln k_p; the gap has the components of y but for the speed, which the section fixes.
std::optional<Closure> closure_of(const Flow& flow, const BranchPoint& at, const CycleOptions& options)
{
    const auto here = flow.with_gain(at.k_p);
    const auto turn = revolve(*here, at.start, options);
    if (!turn) return {};
    constexpr double shift = 1e-5;
    const auto near = revolve(*flow.with_gain(at.k_p * (1 + shift)), at.start, options);
    if (!near) return {};
    const int n = flow.size();
    const FlowVector scale = flow.scale();
    FlowVector rate;
    here->rate(turn->end, rate);
    const FlowVector normal = here->speed_gradient(turn->end);
    const FlowMatrix onto = FlowMatrix::Identity(n, n) - rate * normal.transpose() / normal.dot(rate);
    const FlowMatrix moved = onto * turn->displacement - FlowMatrix::Identity(n, n);
    const auto without_speed = [n](const FlowVector& v) {
        RealVector r(n - 1);
        r[0] = v[0];
        r.tail(n - 2) = v.tail(n - 2);
        return r;
    };
    Closure c;
    c.gap = without_speed((turn->end - at.start).cwiseQuotient(scale));
    c.by_unknowns.resize(n - 1, n - 1);
    for (int j = 2; j < n; ++j)
        c.by_unknowns.col(j - 2) = without_speed((moved.col(j) * scale[j]).cwiseQuotient(scale));
    c.by_unknowns.col(n - 2) = without_speed((near->end - turn->end).cwiseQuotient(scale) / shift);
    return c;
}

constexpr double least_amplitude = 0.01;  ///< per scale: a branch that comes down to it ends at its Hopf point
constexpr double shortest_step = 2e-3;    ///< of an amplitude along a branch, relative

/// The branch point of amplitude `a` with the rest scaled or extrapolated from known neighbours.
BranchPoint predict(const Flow& flow, const std::deque<BranchPoint>& known, double a)
{
    const FlowVector steady = flow.steady();
    const auto& last = known.back();
    BranchPoint guess = last;
    const double factor = a / last.start[0];
    guess.start = steady + factor * (last.start - steady);
    if (known.size() > 1) {
        const auto& before = known[known.size() - 2];
        const double share = (a - last.start[0]) / (last.start[0] - before.start[0]);
        guess.start = last.start + share * (last.start - before.start);
        guess.k_p = last.k_p + share * (last.k_p - before.k_p);
    }
    guess.start[0] = a;
    guess.start[1] = steady[1];
    return guess;
}

/// Abscissa of the extremum of the parabola through three points, in ln amplitude.
double vertex(const BranchPoint& p, const BranchPoint& q, const BranchPoint& r)
{
    const double a = std::log(p.start[0]), b = std::log(q.start[0]), c = std::log(r.start[0]);
    const double ba = (b - a) * (q.k_p - r.k_p), bc = (b - c) * (q.k_p - p.k_p);
    return std::exp(b - 0.5 * ((b - a) * ba - (b - c) * bc) / (ba - bc));
}

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

std::optional<BranchPoint> cycle_of_amplitude(const Flow& flow, const BranchPoint& guess, const CycleOptions& options)
{
    BranchPoint at = guess;
    const FlowVector scale = flow.scale();
    const int n = flow.size();
    const double size = std::abs(guess.start[0]) / scale[0];
    for (int i = 0; i < options.newton_steps; ++i) {
        const auto c = closure_of(flow, at, options);
        if (!c) return {};
        if (c->gap.cwiseAbs().maxCoeff() < options.closure * std::min(1.0, size)) return at;
        const RealVector step = -c->by_unknowns.fullPivLu().solve(c->gap);
        if (!step.allFinite() || std::abs(step[n - 2]) > 0.5) return {};
        for (int j = 2; j < n; ++j) at.start[j] += step[j - 2] * scale[j];
        at.k_p *= std::exp(step[n - 2]);
    }
    return {};
}

namespace {

/// The largest gain of the branch between p and r, q being the largest so far and between them in amplitude.
std::optional<BranchPoint> highest_between(const Flow& flow, BranchPoint p, BranchPoint q, BranchPoint r,
                                           const CycleOptions& options)
{
    for (int i = 0; i < 8; ++i) {
        const auto top = cycle_of_amplitude(flow, predict(flow, {p, q}, vertex(p, q, r)), options);
        if (!top) return {};
        const double change = std::abs(top->k_p / q.k_p - 1);
        // the new point and its nearest neighbours on either side
        if (top->k_p >= q.k_p)
            ((top->start[0] > q.start[0]) == (r.start[0] > q.start[0]) ? p : r) = q, q = *top;
        else
            ((top->start[0] > q.start[0]) == (r.start[0] > q.start[0]) ? r : p) = *top;
        if (change < 1e-10) break;
    }
    return q;
}

}  // namespace

std::optional<BranchPoint> fold_of_cycles(const Flow& flow, const BranchPoint& on_branch, const CycleOptions& options)
{
    std::deque<BranchPoint> known{on_branch}, lower;
    double factor = 1.03;
    for (const double trial : {factor, 1 / factor}) {  // which way the gain rises
        const auto next = cycle_of_amplitude(flow, predict(flow, {on_branch}, on_branch.start[0] * trial), options);
        if (next && next->k_p <= on_branch.k_p) lower.push_back(*next);
        if (!next || next->k_p <= on_branch.k_p) continue;
        factor = trial;
        known.push_back(*next);
        break;
    }
    // the start may stand at the fold itself
    if (lower.size() == 2) return highest_between(flow, lower.front(), on_branch, lower.back(), options);
    if (known.size() < 2) return {};
    const double least = std::min(least_amplitude * flow.scale()[0], 0.5 * on_branch.start[0]);
    for (int i = 0; i < 400 && known.back().k_p > known[known.size() - 2].k_p; ++i) {
        const auto next = cycle_of_amplitude(flow, predict(flow, known, known.back().start[0] * factor), options);
        if (!next) {
            if (std::abs(factor - 1) < shortest_step) return {};
            factor = std::sqrt(factor);
            continue;
        }
        if (next->start[0] < least) return {};
        known.push_back(*next);
        if (i > 3 && i % 4 == 0) factor = std::clamp(factor * factor, 1 / 1.15, 1.15);
    }
    if (known.back().k_p > known[known.size() - 2].k_p || known.size() < 3) return {};
    return highest_between(flow, known[known.size() - 3], known[known.size() - 2], known.back(), options);
}

BranchPoint last_at_rising_gain(const Flow& flow, BranchPoint at, const CycleOptions& options)
{
    constexpr double first = 1.3, shortest = 1.002;
    constexpr int most = 80;
    double step = first;
    for (int i = 0; i < most && step > shortest; ++i) {
        const double k_p = at.k_p * step;
        const auto next = find_cycle(*flow.with_gain(k_p), at.start, options);
        if (!next || !(next->velocity_min > 0)) {
            step = std::sqrt(step);
            continue;
        }
        at = {k_p, next->start};
    }
    return at;
}

std::optional<BranchPoint> fold_of_cycles(const Flow& flow, const HopfPoint& hopf, const CycleOptions& options)
{
    if (!(hopf.lyapunov > 0)) return {};
    // next to a degenerate point the gain of a branch runs off within small amplitudes: smaller ones are tried, too
    for (const double amplitude : {0.05, 0.01, 2e-3, 5e-4}) {
        const double a = amplitude * flow.scale()[0];
        BranchPoint guess{hopf.k_p, flow.steady() + a * hopf.direction};
        guess.start[1] = flow.steady()[1];
        const auto start = cycle_of_amplitude(*flow.with_gain(hopf.k_p), guess, options);
        if (start) return fold_of_cycles(flow, *start, options);
    }
    return {};
}

}  // namespace stickslip
