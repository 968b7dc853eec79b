#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "analysis/simulation/attractor/growth.h"
#include "analysis/simulation/flows/delayed_flow.h"
#include "analysis/simulation/solvers/motion.h"
#include "analysis/stability/joint_spectrum.h"

namespace stickslip {
namespace {

constexpr double probe_size = 1e-4;  ///< of the flow's scale: the disturbance whose growth is measured

/// Relative tolerances of the two motions whose growth must agree. Finer ones drown in the rounding of forces.
constexpr double coarse_tolerance = 1e-12, fine_tolerance = 1e-13;

FlowVector longer_by_clock(const FlowVector& y)
{
    FlowVector longer(y.size() + 1);
    longer << y, 0;
    return longer;
}

/// The mode as the chain without the clock sees it.
SlowMode of_chain(const DelayedFlow& flow, const SlowMode& mode)
{
    SlowMode shorter = mode;
    const auto n = flow.chain().size();
    shorter.left = mode.left.head(n);
    shorter.right = mode.right.head(n);
    shorter.steady = mode.steady.head(n);
    return shorter;
}

/// What became of the projection on the mode, per unit of time and as a logarithm; not a number where the motion leaves
/// forward sliding. With l the left null vector of sI − A_0 − Σ A_i e^{−sτ_i}, z = l·X + Σ ∫ e^{−s(ξ+τ_i−t)} l·A_i X(ξ)
/// dξ over the last lags obeys z' = s z exactly, whatever the endless other modes do (J. K. Hale, Theory of Functional
/// Differential Equations, 7.3). Motions from both sides of steady sliding cancel the even powers of the disturbance.
double growth_at(double rtol, const DelayedFlow& flow, const SlowMode& mode, const FlowVector& offset)
{
    const double window = mode.window();
    std::complex<double> difference = 0;
    for (const double side : {1.0, -1.0}) {
        SlidingMotion motion(flow, Solver::rodas5p, rtol);
        motion.start(mode.steady + side * offset);
        while (motion.time() < window) {
            const Turn turn = motion.turn(window);
            if (turn.sticks > 0 || (turn.end != Turn::End::crossing && turn.end != Turn::End::time)) return missing;
        }
        const auto& past = static_cast<const DelayedFlow&>(motion.flow());
        const FlowVector& y = motion.state();
        std::complex<double> z = (mode.left.transpose() * (y - mode.steady).cast<std::complex<double>>())(0);
        for (int i = 0; i < flow.chain().bodies; ++i)
            if (flow.lag(i) > 0)
                z += mode.left[flow.chain().bodies + i] * flow.delayed_rate(i) *
                     past.history(i).memory(mode.s, flow.lag(i), past.clock(y));
        difference += side * z;
    }
    return std::log(std::abs(difference) / (2 * mode.size(mode.steady + offset))) / window;
}

}  // namespace

SlowMode slow_mode(const DelayedFlow& flow)
{
    using Complex = std::complex<double>;
    const auto& chain = flow.chain();
    const int n = chain.size();
    SlowMode mode;
    mode.steady = flow.steady();
    const auto roots = spectrum(chain.loop);
    if (roots.empty()) return mode;
    mode.s = roots.front();
    mode.fastest = 0;
    for (const auto& s : roots) mode.fastest = std::max(mode.fastest, std::abs(s));

    FlowMatrix J;
    chain.jacobian(chain.steady(), J);
    Eigen::MatrixXcd characteristic = mode.s * Eigen::MatrixXcd::Identity(n, n) - J.cast<Complex>();
    for (int i = 0; i < chain.bodies; ++i)
        if (flow.lag(i) > 0)
            characteristic(chain.bodies + i, chain.bodies + i) -=
                flow.delayed_rate(i) * std::exp(-mode.s * flow.lag(i));
    const Eigen::VectorXcd scale = chain.scale().cast<Complex>();
    const Eigen::MatrixXcd scaled = scale.cwiseInverse().asDiagonal() * characteristic * scale.asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(scaled, Eigen::ComputeFullU | Eigen::ComputeFullV);
    mode.left = Eigen::VectorXcd::Zero(n + 1);
    mode.right = Eigen::VectorXcd::Zero(n + 1);
    mode.left.head(n) = scale.cwiseInverse().cwiseProduct(svd.matrixU().col(n - 1).conjugate());
    mode.right.head(n) = scale.cwiseProduct(svd.matrixV().col(n - 1));
    return mode;
}

double default_size(const DelayedFlow& flow, const SlowMode& mode, DisturbanceKind kind)
{
    return default_size(flow.chain(), mode, kind);
}

FlowVector disturbed(const DelayedFlow& flow, const SlowMode& mode, DisturbanceKind kind, double size)
{
    const auto& chain = flow.chain();
    const bool one = chain.bodies == 1;
    if (one && kind == DisturbanceKind::velocity) kind = DisturbanceKind::impulse, size *= chain.body[0].inertia;
    if (one && kind == DisturbanceKind::position) kind = DisturbanceKind::offset;
    return longer_by_clock(disturbed(chain, of_chain(flow, mode), kind, size));
}

void push(const DelayedFlow& flow, FlowVector& y, double impulse)
{
    FlowVector of_chain = y.head(flow.chain().size());
    push(flow.chain(), of_chain, impulse);
    y.head(flow.chain().size()) = of_chain;
}

double measure_growth(const DelayedFlow& flow, const SlowMode& mode, const FlowVector& probe)
{
    const FlowVector offset = probe * (probe_size / size_of(flow, mode, probe));
    const double coarse = growth_at(coarse_tolerance, flow, mode, offset);
    if (!std::isfinite(coarse)) return missing;
    const double fine = growth_at(fine_tolerance, flow, mode, offset);
    return std::abs(fine - coarse) < growth_precision * std::abs(fine) ? fine : missing;
}

}  // namespace stickslip
