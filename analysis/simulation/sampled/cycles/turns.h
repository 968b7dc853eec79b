// What a motion in a loop is made of: turns about the commanded velocity, each with its extrema.
#pragma once
#include "analysis/simulation/sampled/plant/driven_motion.h"

namespace stickslip {

/// From one downward crossing of V = V_0 by the link to the next. Extrema lie between the ends of steps and are found
/// there; positions are in excess of the steady path.
struct LoopTurn {
    double t0 = 0, t1 = 0;
    double velocity_min = infinity, velocity_max = -infinity;
    double position_min = infinity, position_max = -infinity;
    double rest_time = 0;  ///< at rest or below near_rest · V_0
    bool reversed = false;

    double period() const { return t1 - t0; }
    double amplitude() const { return 0.5 * (position_max - position_min); }
    /// The largest excess of position and the least velocity along the commanded direction.
    double peak(double V0) const { return V0 < 0 ? -position_min : position_max; }
    double slowest(double V0) const { return V0 < 0 ? -velocity_max : velocity_min; }
};

/// A velocity of a motion about V_0, 0 where it is no more than the rounding of a rest.
double or_rest(double velocity, double V0);

/// Watches steps. `V0` is the velocity of the link that turns are counted about, `origin` its steady position.
class TurnWatch {
  public:
    TurnWatch(double V0, double origin) : V0_(V0), origin_(origin) {}

    void operator()(const DrivenStep& step);
    /// The same in parts, from who finds events himself: a place of the motion that may be an extremum, the passage of
    /// V_0 at a position, time at rest, motion backwards.
    void visit(double velocity, double position);
    void pass(double t, double position, bool downwards);
    void rest(double duration) { now_.rest_time += duration; }
    void reverse() { now_.reversed = true; }
    /// The turn that the last crossing ended, once.
    bool take(LoopTurn& turn);
    /// Since the last crossing, or since reset().
    const LoopTurn& present() const { return now_; }
    void reset(double t);

  private:
    double crossing(const DrivenStep& step, double level, double from, double to) const;

    double V0_, origin_;
    LoopTurn now_, done_;
    bool begun_ = false, has_done_ = false;
};

}  // namespace stickslip
