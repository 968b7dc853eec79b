// The loop that a joint has, about steady sliding: its linear mechanism under a controller that is sampled, late,
// filtered or integrates. One function chooses the loop; verdict.h asks it.
#pragma once
#include <optional>
#include <variant>

#include "analysis/loop/delayed_loop.h"
#include "analysis/loop/discrete_search.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// What the actuator makes of a small command at the effort of steady sliding: effort = gain · u − drag · v, in joint
/// coordinates. Reading: `scale` per joint displacement.
struct Actuation {
    double gain = 1, drag = 0, scale = 1;
};

/// At the commanded velocity. NaN where the supply cannot bring the effort up.
Actuation actuation(const Joint& joint, double velocity, double effort);

/// The effort on the motor, in joint coordinates, that slides the joint steadily at V, its load taken off.
double steady_effort(const Joint& joint, double velocity);

/// Whether the limits of controller and actuator leave that effort: without it there is no steady sliding.
bool limits_leave(const Joint& joint, double velocity);

/// Steady sliding, or why there is none: its own reasons and those limits.
SteadySliding possible_sliding(const Joint& joint);

/// The gain that windows and crossings are given in.
enum class TurnedGain { k_p, k_v, all };

/// The joint about steady sliding at V under its loop, with one gain open and its present value. A force loop with
/// anything turned but all of it has none.
struct RealLoop {
    std::variant<DiscreteLoop, DelayedLoop> loop;
    double gain = 1;
    /// What is reported, k_p of a cascade by its position gain: at_none + per_gain times the gain that is open.
    double per_gain = 1, at_none = 0;
};
/// Whether a controller averages so few readings that the map from tick to tick can hold them.
bool remembers_little(const Joint& joint);

std::optional<RealLoop> real_loop(const Joint& joint, const LinearJoint& linear, double velocity, TurnedGain turned);

/// The mechanism about steady sliding at V with its actuator, without its controller.
LoopPlant loop_plant(const Joint& joint, const LinearJoint& linear, double velocity);

/// Of a sampled loop with delayed friction: from the command to the position of the link at the ticks, opened; the gain
/// that is open is 1. Nothing where the whole loop has none.
std::optional<DelayedLoop> link_by_command(const Joint& joint, const LinearJoint& linear, double velocity);

/// The windows of the gain that is open, in what is reported. Ticks and dead time always leave an end above.
StableGains turned_gains(const RealLoop& loop);

/// max Re s, or max ln|z|/T.
double growth(const RealLoop& loop);

/// A number with that sign, which costs less of loops with dead time or delayed friction.
double side(const RealLoop& loop);

/// The loop opened at the command; all NaN where there is none.
CommandMargins real_margins(const Joint& joint);

/// Fills in the margins of an ideal loop, which verdicts do without as they take long beside it.
void add_margins(const Joint& joint, LinearVerdict& verdict);

/// Slope of the steady curve, direct effect and kernel integral, summed over all bodies, whatever the loop.
void add_frictions(const LinearJoint& linear, LinearVerdict& verdict);

/// Both theories under the joint's own loop, in the terms of the ideal one.
LinearVerdict real_verdict(const Joint& joint, LinearVerdict verdict);
double real_growth(const Joint& joint, bool velocity_only_friction);
double real_side(const Joint& joint, bool velocity_only_friction);
/// Whether the growth takes a search that costs many times the side: of loops that delay friction.
bool growth_is_costly(const Joint& joint);
/// The root of the loop whose real part is the growth, in the upper half plane; of a sampled one ln z / T. NaN where
/// there is none.
std::complex<double> real_root(const Joint& joint);
PointResult real_point(const Joint& joint);

}  // namespace stickslip
