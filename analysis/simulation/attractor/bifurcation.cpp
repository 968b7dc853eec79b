// The branch of cycles, from its Hopf point to its fold.
#include "analysis/simulation/attractor/bifurcation.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace stickslip {
namespace {

using RealMatrix = Eigen::MatrixXd;
using RealVector = Eigen::VectorXd;

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
