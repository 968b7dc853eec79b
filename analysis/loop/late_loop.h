// A linear mechanism under a continuous controller behind dead time: roots, growth, every crossing of the axis.
#pragma once
#include <complex>
#include <vector>

#include "analysis/base/crossing.h"
#include "analysis/loop/command_margins.h"
#include "analysis/loop/sampled_loop.h"

namespace stickslip {

/// Ẋ = A X + input w(t − delay), w = −g output X + held X: mechanism, lag, filter and integral. `base` is in `held`.
struct LateLoop {
    Eigen::MatrixXd A;
    Eigen::VectorXd input;
    Eigen::RowVectorXd held, output;
    double delay = 0;
};

/// u = −(position + velocity s/(τs + 1) + integral/s + travelled/(τs + 1)) y; `base` acts, `turned` acts g times.
LateLoop late_loop(const LoopPlant& plant, double delay, double tau, const LoopGains& base, const LoopGains& turned);

/// The closed loop as a finite system: its states, then the past of the command at `nodes` Chebyshev nodes.
Eigen::MatrixXd late_matrix(const LateLoop& loop, double gain, int nodes);

/// Roots with the gain closed, by falling real part: all of them without dead time; else the rightmost, from the past
/// of the command at Chebyshev nodes, each polished by Newton's method (Breda, Maset & Vermiglio 2005).
std::vector<std::complex<double>> roots(const LateLoop& loop, double gain);

/// max Re s, confirmed by the argument principle: none lies to its right. 0 where only rounding is left of it, NaN
/// where it cannot be confirmed or the loop is not finite.
double late_growth(const LateLoop& loop, double gain);

/// Every crossing of the imaginary axis with 0 < gain ≤ searched_to, ascending in the gain, by steps of ω over which
/// the phase of the loop turns little: a feature narrower than a step can be missed; `doubtful` are steps that no
/// refinement made smooth.
struct AxisCrossings {
    std::vector<Crossing> crossings;
    std::vector<Interval> doubtful;
    double searched_to = infinity;
};
AxisCrossings axis_crossings(const LateLoop& loop);

/// The open intervals of the gain in which all roots decay. Where that cannot be confirmed between two crossings,
/// `searched_to` comes down to the lower of them.
std::vector<Interval> stable_gains(const LateLoop& loop, AxisCrossings& crossings, double own);

/// The loop opened at the command, `output` being all of its gains and `held` none.
CommandMargins command_margins(const LateLoop& loop);

}  // namespace stickslip
