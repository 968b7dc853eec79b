// What a simulator of robots can take of a joint, and what it cannot say.
#pragma once
#include "sweep/study/export/simulator_joint.h"

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

enum class Simulator { mjcf, urdf, sdf, isaaclab, ros2_control };
inline constexpr Choice<Simulator> simulators[] = {{"mjcf", Simulator::mjcf},
                                                   {"urdf", Simulator::urdf},
                                                   {"sdf", Simulator::sdf},
                                                   {"isaaclab", Simulator::isaaclab},
                                                   {"ros2_control", Simulator::ros2_control}};

/// Why a key of the joint does not reach the simulator.
enum class Lost {
    no_element,           ///< nothing in the target stands for it
    from_the_robot,       ///< the robot's own description has it
    joined_to_link,       ///< reflected inertia became part of the link's
    hardening,            ///< a spring is linear
    rigid,                ///< compliance: motor and link move as one
    three_bodies,         ///< the middle body joined the motor
    backlash,             ///< no dead band
    static_rise,          ///< friction above the Coulomb level at rest and low speed
    memory,               ///< friction that remembers
    presliding,           ///< friction that springs before it slides
    direction,            ///< different in both directions
    position_dependent,   ///< locked to position
    time_dependent,       ///< changes in time
    load_dependent,       ///< grows with the transmitted effort
    gains_elsewhere,      ///< the target describes mechanism only
    mechanism_elsewhere,  ///< the target describes control only
    delay_of_target,      ///< the simulator delays what is commanded, not what the loop feeds back
    lag,                  ///< of the actuator
    sampling,             ///< the simulator's loop runs at its own time step
    estimate,             ///< the controller's filter of velocity
    sensor,               ///< noise and quantisation inside the loop
    feedback_side,        ///< loop closed at the link around a motor
    supply,               ///< limits by voltage and current
    integral,             ///< on the error, its limits and what it does at them
    feed_forward,
    not_position_control,
    damped_gap,  ///< damping of a transmission acts in its dead band, too
};

/// Whether the exported actuator delays its target by the dead time; the feedback is delayed nowhere.
constexpr bool delays_target(Simulator to)
{
    return to == Simulator::isaaclab;
}

/// As JSON calls it.
constexpr std::string_view name_of(Lost why)
{
    constexpr std::string_view names[] = {"no-element",      "from-the-robot",
                                          "joined-to-link",  "hardening",
                                          "rigid",           "three-bodies",
                                          "backlash",        "static-rise",
                                          "memory",          "presliding",
                                          "direction",       "position-dependent",
                                          "time-dependent",  "load-dependent",
                                          "gains-elsewhere", "mechanism-elsewhere",
                                          "delay-of-target", "lag",
                                          "sampling",        "estimate",
                                          "sensor",          "feedback-side",
                                          "supply",          "integral",
                                          "feed-forward",    "not-position-control",
                                          "damped-gap"};
    static_assert(std::size(names) == static_cast<std::size_t>(Lost::damped_gap) + 1);
    return names[static_cast<std::size_t>(why)];
}

struct NotExpressible {
    std::string key;
    Lost why = Lost::no_element;
};

struct ExportOptions {
    SplitOptions split;
    double timestep = not_set;  ///< of the simulator; not set: its usual one, shorter where the joint needs it
};

/// What a signal of the records still differs by, RMS in its unit.
struct SignalLeft {
    std::string signal, unit;
    double joint = 0;  ///< from a run of the joint as it is, without noise
    double text = 0;   ///< from a run of what the text holds of it
    double floor = 0;  ///< by noise alone
};

struct GapLeft {
    double joint = 0, text = 0;  ///< RMS over the signals, each over its noise floor, as the diagnosis counts them
    std::vector<SignalLeft> signals;
};

struct ExportAnswer {
    Simulator to = Simulator::mjcf;
    SimulatorJoint joint;
    double timestep = not_set;
    int delay_steps = 0;
    std::vector<NotExpressible> not_expressible;
    std::optional<GapLeft> gap_left;  ///< where records were given
};

ExportAnswer export_joint(const Joint& joint, Simulator to, const ExportOptions& options = {});

}  // namespace stickslip
