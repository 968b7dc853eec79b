// A linear mechanism under a controller behind dead time: roots, growth, every crossing of the border of stability.
// Continuous, or sampled where dead time is many ticks or friction is delayed, so that no small matrix is the loop.
#pragma once
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/base/crossing.h"
#include "analysis/loop/command_margins.h"
#include "analysis/loop/discrete_loop.h"

namespace stickslip {

/// Friction of a body that is delayed: `answer`(s) times the speed that it reads pushes the mechanism, which is that
/// of its `delays`, and of a table. A delay of 0 takes off what the mechanism already has.
struct DelayedFriction {
    struct Delay {
        double weight, time;
    };
    Eigen::VectorXd push;
    Eigen::RowVectorXd speed;
    std::function<std::complex<double>(std::complex<double>)> answer;
    std::vector<Delay> delays;
    double memory = 0;         ///< s, the longest that it goes back
    bool only_delays = false;  ///< that is all of `answer`
};

/// A mechanism with delayed friction: `roots_right_of` a vertical line are those of it alone, and nothing
/// where they cannot be counted.
struct DelayedPlant {
    LoopPlant prompt;
    std::vector<DelayedFriction> friction;
    std::function<std::optional<int>(double)> roots_right_of;
};

/// What a sampled loop knows of delayed friction: the mechanism between ticks, and the loop around it.
struct TickedFriction {
    LoopPlant plant;
    LoopTiming timing;
    LoopGains base, turned;
};

/// Ẋ = A X + input w(t − delay), w = −g output X + held X: mechanism, lag, filter and integral; `base` is in `held`.
/// Of a sampled loop X_{k+1} = (1 + A) X_k + input w_{k − delay/period}.
struct DelayedLoop {
    Eigen::MatrixXd A;
    Eigen::VectorXd input;
    Eigen::RowVectorXd held, output;
    double delay = 0;
    double period = 0;                      ///< of a sampled loop
    std::vector<DelayedFriction> friction;  ///< beside A: of its states, of a sampled loop those of the mechanism
    std::function<std::optional<int>(double)> mechanism_right_of;  ///< set where friction is delayed
    std::vector<double> other_poles;  ///< then those of the lag and of the controller, in s
    std::shared_ptr<const TickedFriction> ticked;

    /// Whether its roots are those of a matrix.
    bool finite() const { return delay == 0 && period == 0 && friction.empty(); }
};

/// u = −(position + velocity s/(τs + 1) + integral/s + travelled/(τs + 1)) y; `base` acts, `turned` acts g times.
DelayedLoop delayed_loop(const DelayedPlant& plant, double delay, double tau, double lag, const LoopGains& base,
                         const LoopGains& turned);

/// The same loop as discrete_loop(), with its whole ticks of dead time and delayed friction aside. Nothing where what
/// is turned acts in two places of the loop.
std::optional<DelayedLoop> delayed_sampled_loop(const DelayedPlant& plant, const LoopTiming& timing, double lag,
                                                const LoopGains& base, const LoopGains& turned);

/// The closed loop as a finite system: its states, then the past of the command, and of the speeds that friction reads
/// late, at `nodes` Chebyshev nodes each. Of continuous loops; what friction has as a table is left out.
Eigen::MatrixXd delayed_matrix(const DelayedLoop& loop, double gain, int nodes);

/// Where the rightmost roots of a sampled loop about lie, by falling real part, in the upper half plane: those of a
/// matrix that holds the delays of friction at a few Chebyshev nodes. Starts for Newton's method, which costs far less
/// from there than a search. None where friction has a table or the matrix would be large.
std::vector<std::complex<double>> rough_roots(const DelayedLoop& loop, double gain);

/// Roots with the gain closed, by falling real part; of a sampled loop ln(z)/T. All of them where they are those of a
/// matrix; else the rightmost: from the past of the command at Chebyshev nodes (Breda, Maset & Vermiglio 2005) or,
/// where there is no such matrix, from where the loop turns fastest along lines; each polished by Newton's method.
std::vector<std::complex<double>> roots(const DelayedLoop& loop, double gain);

/// Those roots, and the growth that delayed_growth() finds with them.
struct DelayedSpectrum {
    std::vector<std::complex<double>> roots;
    double growth = not_set;
};
DelayedSpectrum delayed_spectrum(const DelayedLoop& loop, double gain);

/// The rightmost of them, in the upper half plane, by lines; nothing where counting does not confirm it.
std::optional<std::complex<double>> rightmost_root(const DelayedLoop& loop, double gain);

/// max Re s, confirmed by the argument principle: none lies to its right. 0 where only rounding is left of it, NaN
/// where it cannot be confirmed or the loop is not finite.
double delayed_growth(const DelayedLoop& loop, double gain);

/// A number with the sign of delayed_growth(), by counts of roots where these decide it, which costs much less.
double delayed_side(const DelayedLoop& loop, double gain);

/// Every crossing of the imaginary axis with 0 < gain ≤ searched_to, ascending in the gain, by steps of ω over which
/// the phase of the loop turns little: a feature narrower than a step can be missed; `doubtful` are steps that no
/// refinement made smooth.
struct AxisCrossings {
    std::vector<Crossing> crossings;
    std::vector<Interval> doubtful;
    double searched_to = infinity;
};
AxisCrossings axis_crossings(const DelayedLoop& loop);

/// The open intervals of the gain in which all roots decay. Where that cannot be confirmed between two crossings,
/// `searched_to` comes down to the lower of them.
std::vector<Interval> stable_gains(const DelayedLoop& loop, AxisCrossings& crossings, double own);

/// The loop opened at the command, `output` being all of its gains and `held` none; `closed` is its spectrum.
CommandMargins command_margins(const DelayedLoop& loop, const DelayedSpectrum& closed);

}  // namespace stickslip
