#include "analysis/simulation/attractor/cycle.h"

#include "analysis/numerics/hermite.h"
#include "analysis/simulation/attractor/series_turn.h"
#include "analysis/simulation/solvers/motion.h"
#include "analysis/simulation/solvers/rodas5p.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double amplitude_precision = 1e-4;  ///< of a cycle, per amplitude

double slope(const Flow& flow, const FlowVector& y)
{
    FlowVector rate;
    flow.rate(y, rate);
    return flow.speed_gradient(y).dot(rate);
}

void widen(const Flow& flow, const RodasStep& step, Cycle& path)
{
    const double m0 = flow.speed_measure(step.y), m1 = flow.speed_measure(step.y1);
    path.velocity_min = std::min(path.velocity_min, flow.velocity(step.y1));
    path.velocity_max = std::max(path.velocity_max, flow.velocity(step.y1));
    // the slopes of a stiff motion tell where it turns, but their cubic runs decades beyond the motion
    if (const auto at = hermite_turning(m0, m1, slope(flow, step.y), slope(flow, step.y1), step.h)) {
        const double peak = flow.velocity(step.dense(*at));
        path.velocity_min = std::min(path.velocity_min, peak);
        path.velocity_max = std::max(path.velocity_max, peak);
    }
    path.position_min = std::min(path.position_min, flow.position(step.y1));
    path.position_max = std::max(path.position_max, flow.position(step.y1));
    // x is extremal where V = V_0: a step across the section hides up to h² of it
    if (m0 * m1 < 0) {
        const double fraction = m0 / (m0 - m1);
        const double x = flow.position(step.dense(fraction));
        path.position_min = std::min(path.position_min, x);
        path.position_max = std::max(path.position_max, x);
    }
    const auto is_slow = [&](const FlowVector& y) { return flow.velocity(y) < near_rest * flow.commanded_velocity(); };
    const bool slow0 = is_slow(step.y), slow1 = is_slow(step.y1);
    if (slow0 && slow1) path.rest_time += step.h;
    if (slow0 == slow1) return;
    double before = 0, after = 1;  // speed spans decades within a step: only its own course says where it is slow
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (before + after);
        (is_slow(step.dense(middle)) == slow0 ? before : after) = middle;
    }
    path.rest_time += step.h * (slow0 ? before : 1 - before);
}

/// One revolution step by step.
std::optional<Revolution> stepped_revolution(const Flow& flow, const FlowVector& start, const CycleOptions& options)
{
    const int n = flow.size();
    const FlowVector scale = flow.scale();
    Revolution turn;
    Cycle& path = turn.path;
    path.start = start;
    path.velocity_min = path.velocity_max = flow.velocity(start);
    path.position_min = path.position_max = flow.position(start);
    path.period = 0;
    FlowMatrix phi = FlowMatrix::Identity(n, n);
    RodasStep step;
    step.y = start;
    double h = first_step(flow, start);
    bool below = false;  // has left the section downwards
    int returns = 0;
    for (int count = 0; count < options.step_limit; ++count) {
        if (options.work && options.work->spent()) return {};
        if (options.work) options.work->spend(Work::of_step(n));
        step.h = h;
        FlowMatrix next = rodas5p_step(flow, step, phi);
        const double error = scaled_error(step, scale, options.rtol);
        const double factor = step_factor(error);
        if (!(error <= 1)) {
            h *= std::min(factor, 0.9);
            if (!(h > 1e-16 * (path.period + h)) || !std::isfinite(h)) return {};
            continue;
        }
        const double m0 = flow.speed_measure(step.y), m1 = flow.speed_measure(step.y1);
        const bool returned = below && m0 > 0 && m1 <= 0;
        if (returned && ++returns == options.turns) {
            double h_old = 0, f_old = m0, f = m1;  // secant on the length of the step, to the last bit
            for (int k = 0; k < 8 && f != 0 && f != f_old; ++k) {
                const double length = step.h - f * (step.h - h_old) / (f - f_old);
                if (!(length > 0) || std::abs(length - step.h) < 1e-15 * (path.period + step.h)) break;
                h_old = step.h, f_old = f;
                step.h = length;
                next = rodas5p_step(flow, step, phi);
                f = flow.speed_measure(step.y1);
            }
            widen(flow, step, path);
            path.period += step.h;
            turn.end = step.y1;
            turn.displacement = next;
            return turn;
        }
        widen(flow, step, path);
        path.period += step.h;
        if (m1 < 0) below = true;
        phi = next;
        step.y = step.y1;
        h *= factor;
    }
    return {};
}

}  // namespace

std::optional<Revolution> revolve(const Flow& flow, const FlowVector& start, const CycleOptions& options)
{
    if (auto turn = series_revolution(flow, start, options)) return turn;
    return stepped_revolution(flow, start, options);
}

Eigen::VectorXcd floquet_multipliers(const Flow& flow, const Revolution& closed)
{
    const int n = flow.size();
    const FlowVector normal = flow.speed_gradient(closed.end);
    FlowVector rate;
    flow.rate(closed.end, rate);
    const FlowMatrix onto = FlowMatrix::Identity(n, n) - rate * normal.transpose() / normal.dot(rate);
    const FlowVector scale = flow.scale();
    // a basis of the section's tangent space, in units of the scale
    const FlowVector direction = normal.cwiseProduct(scale).normalized();
    const FlowMatrix complete =
        Eigen::HouseholderQR<FlowMatrix>(FlowMatrix(direction)).householderQ() * FlowMatrix::Identity(n, n);
    const FlowMatrix basis = complete.rightCols(n - 1);
    const FlowMatrix map = basis.transpose() * scale.cwiseInverse().asDiagonal() * (onto * closed.displacement) *
                           scale.asDiagonal() * basis;
    Eigen::VectorXcd values = map.eigenvalues();
    std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
    return values;
}

std::optional<Cycle> find_cycle(const Flow& flow, const FlowVector& guess, const CycleOptions& options)
{
    const int n = flow.size();
    const FlowVector scale = flow.scale(), steady = flow.steady();
    FlowVector y = guess;
    double last_gap = std::numeric_limits<double>::infinity();
    for (int k = 0; k < options.newton_steps; ++k) {
        const auto turn = revolve(flow, y, options);
        if (!turn) return {};
        const FlowVector gap = turn->end - y;
        const double size = gap.cwiseQuotient(scale).cwiseAbs().maxCoeff();
        const double distance = (y - steady).cwiseQuotient(scale).cwiseAbs().maxCoeff();
        if (distance < 1e-6) return {};
        if (size <= options.closure * std::max(1.0, distance)) {
            Cycle cycle = turn->path;
            cycle.multipliers = floquet_multipliers(flow, *turn);
            // near neutral modes every orbit nearly closes: what is left of the gap shows how far the closed one is
            const double contraction = std::abs(1 - std::abs(cycle.multipliers[0]));
            if (size <= amplitude_precision * distance * contraction) return cycle;
            if (size >= last_gap) return {};
        }
        if (k > 4 && size > 10 * last_gap) return {};
        last_gap = size;
        FlowVector rate;
        flow.rate(turn->end, rate);
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
        const Eigen::MatrixXd S = scale.asDiagonal(), S_inverse = scale.cwiseInverse().asDiagonal();
        system.topLeftCorner(n, n) = S_inverse * (turn->displacement - FlowMatrix::Identity(n, n)) * S;
        system.topRightCorner(n, 1) = S_inverse * rate;
        system.bottomLeftCorner(1, n) = flow.speed_gradient(y).transpose() * S;
        Eigen::VectorXd right(n + 1);
        right << -gap.cwiseQuotient(scale), -flow.speed_measure(y);
        FlowVector change = scale.cwiseProduct(FlowVector(system.fullPivLu().solve(right).head(n)));
        // a step far beyond the orbit itself has left the region where the linear picture means anything
        const double length = change.cwiseQuotient(scale).cwiseAbs().maxCoeff();
        if (!std::isfinite(length)) return {};
        if (length > 0.5 * distance) change *= 0.5 * distance / length;
        y += change;
    }
    return {};
}

}  // namespace stickslip
