// From stop to stop at a set point, by events: for friction and loops that have no closed form.
#pragma once
#include "analysis/simulation/set_point/regulator.h"

namespace stickslip {

/// How a slip ended.
struct Stop {
    enum class End {
        stop,     ///< at rest, held by static friction
        settled,  ///< the mass creeps into the set point without stopping before
        held,     ///< there was no slip: the controller cannot break the static friction
        runaway,
        failure
    };
    End end = End::failure;
    double x = missing;           ///< position from the set point; the slip began at −a
    double slip_time = missing;   ///< of motion, reversals without a stop included
    double stick_time = missing;  ///< until the integrator breaks away again; infinite: never
    int turns = 0;                ///< reversals without a stop
};

/// Motions at one set point. The friction is set-valued at rest, without states.
class StopToStop {
  public:
    StopToStop(const Regulator& regulator, const Friction& friction);

    /// The slip that begins at −a, where the integrator has just broken the static friction.
    Stop slip_from(double a) const;
    /// To the first rest, held or not, from −a in a loop without an integral; `held` where static friction is not
    /// broken there.
    Stop release_from(double a) const;
    /// The least distance from which the integrator breaks away at all.
    double least_start() const;
    double static_force() const { return static_; }

  private:
    Stop follow(double a, double w, bool to_first_rest) const;
    double breakaway_integral(double x) const;
    double stick_time(double x, double w) const;

    Regulator regulator_;
    Friction friction_;
    double static_ = 0, slowest_ = 0, speed_limit_ = infinity;
};

}  // namespace stickslip
