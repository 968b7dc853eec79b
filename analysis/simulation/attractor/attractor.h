// Where a disturbed motion ends: steady sliding, a limit cycle, something longer, or a reason why it is not known.
#pragma once
#include "analysis/simulation/attractor/cycle.h"
#include "analysis/simulation/solvers/motion.h"
#include "analysis/simulation/solvers/work.h"

namespace stickslip {

struct FollowOptions {
    Solver solver = Solver::cvode;
    double rtol = 1e-8;
    int turn_limit = 3000;
    bool accelerate = true;  ///< shooting and amplitude jumps; without them the motion is only watched
    Work* work = nullptr;    ///< that is left for this motion and others; none: only turns are counted
};

struct Attractor {
    enum class Kind { steady, cycle, period_n, irregular, held, undecided, failure };
    Kind kind = Kind::undecided;
    DecisionPath path = DecisionPath::cvode;
    Reason reason = Reason::none;
    bool used_fallback = false;
    double period = missing, velocity_min = missing, velocity_max = missing;
    double position_min = missing, position_max = missing, rest_time = missing;
    bool reversed = false;
    bool diverged = false;         ///< failed because the speed overflowed
    bool cut_short = false;        ///< undecided because the work was spent
    int repeats = 1;               ///< turns after which a period-n motion repeats
    int turns = 0;                 ///< that were followed
    double first_peak = missing;   ///< largest position excess of the first turn
    FlowVector start;              ///< of the cycle, on the section
    Eigen::VectorXcd multipliers;  ///< where shooting found the cycle

    void take(const Turn& turn);    ///< the cycle that this turn is
    void take(const Cycle& cycle);  ///< and that shooting found
    bool oscillates() const;
    Outcome outcome() const;
};

/// Follows the motion from y to its end. Slow points are decided, not waited for: when turns resemble one another the
/// cycle is computed by shooting, and when the amplitude creeps it is scaled and the sign of its growth looked at
/// again. `steady_attracts` says that the linear theory lets small disturbances decay.
Attractor follow(const Flow& flow, const FlowVector& y, bool steady_attracts, const FollowOptions& options);

/// The same with delayed friction. The past has no dimension that shooting could work in: cycles are watched
/// until they close.
Attractor follow(const DelayedFlow& flow, const FlowVector& y, bool steady_attracts, const FollowOptions& options);

}  // namespace stickslip
