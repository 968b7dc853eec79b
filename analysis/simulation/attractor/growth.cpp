#include "analysis/simulation/attractor/growth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/simulation/solvers/rodas5p.h"

namespace stickslip {
namespace {

/// Disturbances that are followed, in units of the flow's scale, large ones first: they stand above the rounding of
/// states, but not everywhere are they small beside what bends the motion.
constexpr double probe_sizes[] = {1e-3, 1e-4, 1e-5, 1e-6};

/// Change of the rate with the size of the disturbance, per rate. Its square is what extrapolation to size 0 leaves.
constexpr double slightly_bent = 1e-3;

constexpr int fewest_steps = 100, most_steps = 3200;  ///< of the window

constexpr double order = 32;  ///< what half the step leaves of the error of a method of order 5

/// The share of growth_precision that two successive answers may differ by: their difference is the error of the first.
constexpr double agreement = 0.1;

/// The end of a motion in equal steps. To the linear part of a motion a Rosenbrock method applies one and the same
/// rational function of J in each step, so that nothing leaks from the other modes into the projection on this one,
/// however fast they are. Nothing where the motion leaves forward sliding.
std::optional<FlowVector> after(const Flow& flow, const FlowVector& start, double window, int steps)
{
    RodasStep step;
    step.h = window / steps;
    step.y1 = start;
    for (int i = 0; i < steps; ++i) {
        step.y = step.y1;
        rodas5p_step(flow, step);
        if (!step.y1.allFinite() || !(flow.velocity(step.y1) > 0)) return {};
    }
    return step.y1;
}

/// From differences of motions that start on opposite sides of steady sliding, so that even powers of the disturbance
/// cancel, at two sizes, so that the third power does.
struct Rate {
    double value, bend;
};
Rate rate_in(int steps, const Flow& flow, const SlowMode& mode, const FlowVector& probe)
{
    const double window = mode.window();
    const auto rate_of = [&](const FlowVector& offset) {
        const auto up = after(flow, mode.steady + offset, window, steps);
        const auto down = after(flow, mode.steady - offset, window, steps);
        if (!up || !down) return missing;
        const FlowVector difference = *up - *down;
        return std::log(mode.size(mode.steady + difference / 2) / mode.size(mode.steady + offset)) / window;
    };
    const double half = rate_of(probe / 2), whole = rate_of(probe);
    return {(4 * half - whole) / 3, half - whole};
}

/// To which a small disturbance that grows is lifted, in units of the flow's scale; and the size below which it excites
/// its mode so little that the lifted one would drown in the solver's tolerance.
constexpr double lifted_to = 0.1, hidden = 1e-3 * small_disturbance;

}  // namespace

FlowVector lifted(const Flow& flow, const SlowMode& mode, const FlowVector& y)
{
    const double size = size_of(flow, mode, y - mode.steady);
    return mode.steady + lifted_to / (size < hidden ? size : small_disturbance) * (y - mode.steady);
}

double size_of(const Flow& flow, const SlowMode& mode, const FlowVector& offset)
{
    const FlowVector per_scale = flow.scale().cwiseInverse();
    const double own = offset.cwiseProduct(per_scale).lpNorm<Eigen::Infinity>();
    const double of_mode = mode.right.cwiseProduct(per_scale.cast<std::complex<double>>()).lpNorm<Eigen::Infinity>();
    const double share = mode.size(mode.steady + offset) / std::abs((mode.left.transpose() * mode.right)(0));
    return std::max(own, std::min(share * of_mode, small_disturbance));
}

double measure_growth(const Flow& flow, const SlowMode& mode, const FlowVector& probe)
{
    for (const double probe_size : probe_sizes) {
        const FlowVector offset = probe * (probe_size / size_of(flow, mode, probe));
        const Rate first = rate_in(fewest_steps, flow, mode, offset);
        if (!(std::abs(first.bend) < slightly_bent * std::abs(first.value))) continue;
        double coarse = first.value, last = missing;
        for (int steps = 2 * fewest_steps; steps <= most_steps && std::isfinite(coarse); steps *= 2) {
            const double fine = rate_in(steps, flow, mode, offset).value;
            const double best = (order * fine - coarse) / (order - 1);
            if (std::abs(best - last) < agreement * growth_precision * std::abs(best)) return best;
            coarse = fine, last = best;
        }
        return missing;
    }
    return missing;
}

}  // namespace stickslip
