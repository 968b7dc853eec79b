#include "analysis/stability/real_loop.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/stability/effort_limits.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/split_gains.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// Dead time that a sampled loop holds in its matrix, whose eigenvalues cost its third power; more stands aside.
constexpr double most_ticks_in_matrix = 40;

/// A critical gain needs every gain above it, which dead time and ticks never leave and a search may not have seen.
void take_endless(StableGains& gains)
{
    if (!gains.stable.empty() && gains.stable.back().high == infinity) take_single_gain(gains);
}

}  // namespace

bool remembers_little(const Joint& joint)
{
    // as many as dead ticks: the map of a tick is a matrix of that size
    return loop_kind(joint) != LoopKind::sampled || joint.control.velocity_estimate.average <= most_dead_ticks;
}

namespace {

/// Only what is delayed.
LinearFriction delayed_part(LinearFriction friction)
{
    friction.states = 0;
    return friction;
}

LoopTiming timing_of(const Joint& joint)
{
    const auto& v = joint.control.velocity_estimate;
    return {joint.control.period, joint.dead_time(), v.tau, static_cast<int>(v.average), v.form == EstimateForm::exact};
}

/// Delayed friction beside the states of the mechanism, and a count of the roots that they have together.
/// The mechanism has the friction of slow motion, and what is delayed is what differs from that: without any
/// resistance of its own it would be two integrators, of which delayed friction had to take one away near 0, where no
/// digit of the difference is left. Where such friction falls so steeply that the mechanism would grow beyond all
/// digits within a tick, it rises as steeply instead, and what is delayed makes up for twice as much.
DelayedPlant delayed_plant(const Joint& joint, const LinearJoint& linear, double velocity)
{
    constexpr double most_growth = 9;  // as a power of e within a tick; the rest of the digits are those of the sum
    const double tick = loop_kind(joint) == LoopKind::sampled ? joint.control.period : 0;
    LinearJoint slow = linear;
    std::array<double, max_bodies> at_rest{};
    for (int i = 0; i < linear.bodies; ++i) {
        if (linear.friction[i].rational()) continue;
        at_rest[i] = transfer(delayed_part(linear.friction[i]), 0).real();
        if (const double falls = at_rest[i] - linear.friction[i].f_v; falls * tick > most_growth * linear.inertia[i])
            at_rest[i] -= 2 * falls;
        slow.friction[i].f_v -= at_rest[i];
    }
    DelayedPlant delayed{loop_plant(joint, slow, velocity), {}, {}};
    if (linear.rational()) return delayed;
    const auto states = delayed.prompt.A.rows();
    LinearJoint open = opened(joint, linear);
    for (int i = 0; i < open.bodies; ++i) {
        if (open.friction[i].rational()) continue;
        const LinearFriction only = delayed_part(open.friction[i]);
        double memory = only.table ? only.table->duration() : 0;
        std::vector<DelayedFriction::Delay> delays{{-at_rest[i], 0}};
        for (const auto& d : only.delays) {
            memory = std::max(memory, d.time);
            delays.push_back({d.weight, d.time});
        }
        Eigen::VectorXd push = Eigen::VectorXd::Zero(states);
        push.head(open.states()) = rates_per_force(open, i);
        delayed.friction.push_back({push, Eigen::RowVectorXd::Unit(states, open.bodies + i),
                                    [only, still = at_rest[i]](Complex s) { return transfer(only, s) - still; }, delays,
                                    memory, only.table == nullptr});
    }
    open.friction[0].f_v += actuation(joint, velocity, steady_effort(joint, velocity)).drag;
    delayed.roots_right_of = [open](double sigma) { return roots_right_of(open, sigma); };
    return delayed;
}

}  // namespace

std::optional<RealLoop> real_loop(const Joint& joint, const LinearJoint& linear, double velocity, TurnedGain turned)
{
    if (!remembers_little(joint)) return {};
    const bool wired_back = joint.actuator.effort_gain < 0 && joint.control.k_p < 0;
    const auto gains = split(without_stopped_integral(joint), velocity, turned, wired_back ? -1 : 1);
    if (!gains) return {};
    const auto plant = delayed_plant(joint, linear, velocity);
    if (!plant.prompt.A.allFinite() || !plant.prompt.B.allFinite()) return {};
    const double lag = joint.actuator.lag;
    const auto timing = timing_of(joint);
    if (loop_kind(joint) != LoopKind::sampled)
        return RealLoop{delayed_loop(plant, timing.delay, timing.tau, lag, gains->base, gains->turned), gains->gain,
                        gains->per_gain, gains->at_none};
    if (!plant.friction.empty() || timing.delay > most_ticks_in_matrix * timing.period) {
        if (auto loop = delayed_sampled_loop(plant, timing, lag, gains->base, gains->turned))
            return RealLoop{std::move(*loop), gains->gain, gains->per_gain, gains->at_none};
        if (!plant.friction.empty()) return {};
    }
    return RealLoop{discrete_loop(plant.prompt, timing, gains->base, gains->turned), gains->gain, gains->per_gain,
                    gains->at_none};
}

std::optional<DelayedLoop> link_by_command(const Joint& joint, const LinearJoint& linear, double velocity)
{
    auto plant = delayed_plant(joint, linear, velocity);
    plant.prompt.C.setZero(), plant.prompt.C_v.setZero();
    plant.prompt.C[linear.link()] = plant.prompt.C_v[linear.bodies + linear.link()] = 1;
    return delayed_sampled_loop(plant, timing_of(joint), joint.actuator.lag, {}, {1, 0, 0, 0});
}

double growth(const RealLoop& loop)
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop)) return sampled_growth(*sampled, loop.gain);
    return delayed_growth(std::get<DelayedLoop>(loop.loop), loop.gain);
}

double side(const RealLoop& loop)
{
    const auto* delayed = std::get_if<DelayedLoop>(&loop.loop);
    return delayed ? delayed_side(*delayed, loop.gain) : growth(loop);
}

StableGains turned_gains(const RealLoop& loop)
{
    StableGains found;
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop)) {
        auto circle = circle_crossings(*sampled);
        if (!circle.searched) {
            found.doubtful = std::move(circle.doubtful);
            found.searched_from = found.searched_to = loop.gain;
            report(loop, found);
            return found;
        }
        found.stable = stable_gains(*sampled, circle.crossings, loop.gain);
        found.crossings = std::move(circle.crossings);
        found.doubtful = std::move(circle.doubtful);
        report(loop, found);
        take_endless(found);
        return found;
    }
    const auto& delayed = std::get<DelayedLoop>(loop.loop);
    auto axis = axis_crossings(delayed);
    found.stable = stable_gains(delayed, axis, loop.gain);
    found.crossings = std::move(axis.crossings);
    found.doubtful = std::move(axis.doubtful);
    found.searched_to = axis.searched_to;
    report(loop, found);
    take_endless(found);
    return found;
}

}  // namespace stickslip
