// From stop to stop at a set point in the loop as it is: sampled, late, filtered, limited, under what pulls. Motions
// are those of simulate.
#pragma once
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"
#include "analysis/simulation/set_point/regulator.h"

namespace stickslip {

/// How a motion from a rest ended.
struct SampledStop {
    enum class End : std::uint8_t {
        stop,     ///< at rest, held by static friction
        settled,  ///< creeps into the set point
        held,     ///< there was no motion: the controller cannot break the static friction from here
        moves,    ///< goes on without a stop that lasts
        runaway,
        failure
    };
    End end = End::failure;
    double x = missing;           ///< from the set point, signed; of `moves` the largest distance of late
    double slip_time = missing;   ///< of motion, s
    double stick_time = missing;  ///< until the integral breaks away again; infinite: never
};

/// Of one mass whose friction is set-valued at rest, without states.
class SampledStops {
  public:
    SampledStops(const Joint& joint, const Regulator& regulator, double viscous);

    /// The slip that begins at rest at x, where the integral has just broken the static friction.
    SampledStop slip_from(double x) const;
    /// To the next rest from one at x, nothing commanded yet.
    SampledStop release_from(double x) const;
    /// The least distance at that side (±1) from which the integral breaks away at all.
    double least_start(double side) const;

    /// Up to where the encoder reads no error outside the dead zone; 0: everywhere but at the set point it does.
    double unseen() const;

    /// The distance at that side up to which a loop without an integral may rest.
    double band(double side) const;

    /// Whether the two sides of the set point differ.
    bool one_sided() const;

  private:
    class Watch;
    double furthest_with(double reading) const;
    double effort_at_breakaway(double x) const;
    double reading(double x) const { return joint_.sensor.position_scale * x; }
    double read(double x) const;
    double seen_error(double x) const;
    SampledLoop rest_at(double x) const;
    SampledStop follow(SampledLoop& loop, double from) const;
    double stick_time(const SampledLoop& loop, double x) const;
    bool can_break(double x) const;

    Joint joint_;
    Regulator regulator_;
    double static_, per_signal_, slow_time_ = 0, next_time_ = 0, set_place_;
    double late_ = 0;   ///< from a command to all of its effort
    double flush_ = 0;  ///< from a stop to a command that winds evenly
    bool creeps_ = false;
};

}  // namespace stickslip
