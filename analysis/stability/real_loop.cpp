// In one file: one loop from the joint to its windows: plant, gains, and which of the loops it is.
#include "analysis/stability/real_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/joint/drive.h"
#include "analysis/joint/steady_output.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// The mechanism without its loop. Force control keeps the finger, which is no part of the controller.
LinearJoint opened(const Joint& joint, LinearJoint linear)
{
    if (joint.control.kind == ControlKind::position) {
        linear.k_p = linear.k_v = 0;
        return linear;
    }
    linear.actuated[0] -= joint.control.force_gain;
    linear.contact[0] -= joint.control.force_gain * joint.control.contact_stiffness;
    return linear;
}

/// Dead time that a sampled loop holds in its matrix, whose eigenvalues cost its third power; more stands aside.
constexpr double most_ticks_in_matrix = 40;

struct SplitGains {
    LoopGains base, turned;
    double gain;
    double per_gain = 1, at_none = 0;  ///< as in RealLoop
};

/// The sum of gains or the two loops of the controller.
LoopGains controller_gains(const Joint& joint)
{
    const auto& c = joint.control;
    if (c.kind == ControlKind::force) return {c.force_gain, 0, 0, 0};
    if (c.structure == Structure::pid) return {c.k_p, c.k_v, c.k_i, 0};
    const bool sums =
        c.velocity_estimate.tau == 0 &&
        (!is_set(c.period) || (c.velocity_estimate.form != EstimateForm::exact && c.velocity_estimate.average == 1));
    const auto gains = gains_of(c);
    if (sums) return {gains.k_p, gains.k_v, gains.k_i, 0};
    return {c.velocity_gain * c.position_gain, c.velocity_gain, gains.k_i, velocity_integral_gain(c)};
}

/// All that the controller makes of small motions about V. A push by the velocity acts on the same estimate as k_v.
LoopGains all_gains(const Joint& joint, double velocity)
{
    auto gains = controller_gains(joint);
    if (joint.control.kind == ControlKind::position)
        gains.velocity -= push_slope(joint.control.feed_forward, joint.sensor.position_scale * velocity);
    return gains;
}

/// Gains are searched from zero on in the direction `towards`: 1, or −1 where the motor is wired the other way round
/// and its gains are negative for it.
std::optional<SplitGains> split(const Joint& joint, double velocity, TurnedGain turned, double towards)
{
    const auto& c = joint.control;
    LoopGains base = all_gains(joint, velocity);
    if (turned == TurnedGain::all) return SplitGains{{}, base, 1};
    if (c.kind == ControlKind::force) return {};
    if (c.structure == Structure::cascade) {
        // the gain of the position loop turns with k_p and k_i together
        if (turned == TurnedGain::k_v) return {};
        const double K_i = velocity_integral_gain(c);
        base.position -= c.velocity_gain * c.position_gain;
        base.integral = 0;
        return SplitGains{base, {c.velocity_gain, 0, K_i, 0}, c.position_gain, c.velocity_gain, K_i};
    }
    if (turned == TurnedGain::k_p) {
        base.position = 0;
        return SplitGains{base, {towards, 0, 0, 0}, towards * c.k_p, towards};
    }
    base.velocity -= c.k_v;
    return SplitGains{base, {0, towards, 0, 0}, towards * c.k_v, towards};
}

/// k_p = K_v K_pos + K_i of a cascade, in place of the K_pos that was turned, and gains below zero as what they are.
void report(const RealLoop& loop, StableGains& gains)
{
    if (loop.per_gain == 1 && loop.at_none == 0) return;
    const auto reported = [&](double gain) { return loop.at_none + loop.per_gain * gain; };
    for (auto& c : gains.crossings) c.k_p = reported(c.k_p);
    for (auto& i : gains.stable) i = {reported(i.low), reported(i.high)};
    if (std::isfinite(gains.searched_to)) gains.searched_to = reported(gains.searched_to);
    if (loop.per_gain > 0) return;
    if (std::isfinite(gains.searched_to))
        gains.searched_from = std::exchange(gains.searched_to, reported(gains.searched_from));
    for (auto& c : gains.crossings) c.direction = -c.direction;
    for (auto& i : gains.stable) std::swap(i.low, i.high);
    std::reverse(gains.stable.begin(), gains.stable.end());
    std::reverse(gains.crossings.begin(), gains.crossings.end());
}

/// A critical gain needs every gain above it, which dead time and ticks never leave and a search may not have seen.
void take_endless(StableGains& gains)
{
    if (!gains.stable.empty() && gains.stable.back().high == infinity) take_single_gain(gains);
}

}  // namespace

namespace {

/// Positions as that of the link and the stretches of the springs before it, x_i − x_{i+1}: what nothing holds is then
/// an integrator to the last digit, which differences of stiffnesses would leave beside 0.
void take_stretches(const LinearJoint& open, Eigen::MatrixXd& A)
{
    const int n = open.bodies, link = open.link();
    for (int i = 1; i < n; ++i) A.col(i) += A.col(i - 1);
    for (int i = 0; i < link; ++i) A.row(i) -= A.row(i + 1);
    const bool held = open.k_p != 0 || std::any_of(open.contact.begin(), open.contact.begin() + n,
                                                   [](double contact) { return contact != 0; });
    if (!held) A.col(link).setZero();
}

}  // namespace

LoopPlant loop_plant(const Joint& joint, const LinearJoint& linear, double velocity)
{
    const auto acts = actuation(joint, velocity, steady_effort(joint, velocity));
    const LinearJoint open = opened(joint, linear);
    const int n = open.bodies, states = open.states(), lag = joint.actuator.lag > 0;
    LoopPlant plant;
    plant.A = Eigen::MatrixXd::Zero(states + lag, states + lag);
    plant.A.topLeftCorner(states, states) = state_matrix(open);
    take_stretches(open, plant.A);
    const Eigen::VectorXd per_effort = rates_per_force(open, 0);
    plant.A.col(n).head(states) -= acts.drag * per_effort;
    plant.B = Eigen::VectorXd::Zero(states + lag);
    const Eigen::VectorXd push = acts.gain * per_effort;
    if (lag) {
        plant.A.col(states).head(states) = push;
        plant.A(states, states) = -1 / joint.actuator.lag;
        plant.B[states] = 1 / joint.actuator.lag;
    } else {
        plant.B.head(states) = push;
    }
    plant.C = plant.C_v = Eigen::RowVectorXd::Zero(states + lag);
    if (joint.control.kind == ControlKind::position) {
        plant.C.segment(open.measured, n - open.measured).setConstant(acts.scale);
        plant.C_v[n + open.measured] = acts.scale;
    } else {
        plant.C[open.link()] = joint.control.k_p + joint.control.contact_stiffness;
        plant.C[n + open.link()] = joint.control.k_v;
    }
    return plant;
}

double steady_effort(const Joint& joint, double velocity)
{
    if (joint.mechanism.model != Model::single_mass) return carried_efforts(joint, velocity, joint.load.constant)[0];
    const auto& f = joint.friction;
    const double direction = velocity < 0 ? -1 : 1, load = -joint.load.constant;
    const double gear = GearLoss::level(f.gear.forward, f.gear.backward, 0.0, load, 0.0, direction, 0.0);
    return (steady_force(f, velocity) + direction * gear) / (1 - f.load_coefficient) + load;
}

Actuation actuation(const Joint& joint, double velocity, double effort)
{
    const auto& a = joint.actuator;
    Actuation acts;
    acts.scale = joint.sensor.position_scale;
    if (a.kind == ActuatorKind::effort) {
        acts.gain = a.effort_gain;
        if (a.sag_effort < infinity) {
            const double left = 1 - std::abs(effort) / a.sag_effort;  // p/(1 + |p|/s) has the slope (1 − |F|/s)²
            acts.gain *= left > 0 ? left * left : missing;
        }
        return acts;
    }
    // the motor's constants are in joint coordinates, as the gains of the loop and all else
    const double k_t = a.effort_gain * a.k_t;
    const bool duty = a.signal == DriveSignal::duty;
    double R = a.resistance, sagging = 0;
    if (a.supply_resistance > 0 && is_set(a.supply_voltage)) {
        const double D = command_for(a, effort, velocity) / (duty ? 1 : a.supply_voltage);
        // i (R + |D| R_s) = D U − k_e v; of a motor that feeds back (i D < 0) the supply rises
        const double sag = std::abs(D) * a.supply_resistance;
        R = effort / k_t * D < 0 ? std::max(R - sag, least_resistance * R) : R + sag;
        sagging = std::copysign(effort, k_t) * a.supply_resistance / R / (duty ? 1 : a.supply_voltage);
    }
    acts.gain = (k_t / R * (duty ? a.supply_voltage : 1) - sagging);
    acts.drag = k_t * a.k_e / R;
    return acts;
}

bool limits_leave(const Joint& joint, double velocity)
{
    return !low_limit(joint, velocity);
}

SteadySliding possible_sliding(const Joint& joint)
{
    auto steady = steady_sliding(joint);
    const auto& a = joint.actuator;
    const bool limited = joint.control.effort_limit < infinity || a.limit < infinity || a.sag_effort < infinity ||
                         (a.kind == ActuatorKind::dc_motor && is_set(a.supply_voltage));
    if (limited && steady.reason == Reason::none && !limits_leave(joint, steady.velocity))
        steady.reason = Reason::limit_too_low;
    return steady;
}

bool remembers_little(const Joint& joint)
{
    constexpr double most_readings = 1000;  // as many as dead ticks: the map of a tick is a matrix of that size
    return loop_kind(joint) != LoopKind::sampled || joint.control.velocity_estimate.average <= most_readings;
}

namespace {

/// Only what answers late.
LinearFriction late_part(LinearFriction friction)
{
    friction.states = 0;
    return friction;
}

/// Friction that answers late beside the states of the mechanism, and a count of the roots that they have together.
/// The mechanism has the friction of slow motion, and what answers late is what differs from that: without any
/// resistance of its own it would be two integrators, of which late friction had to take one away near 0, where no
/// digit of the difference is left.
LatePlant late_plant(const Joint& joint, const LinearJoint& linear, double velocity)
{
    LinearJoint slow = linear;
    std::array<double, max_bodies> at_rest{};
    for (int i = 0; i < linear.bodies; ++i) {
        if (linear.friction[i].rational()) continue;
        at_rest[i] = transfer(late_part(linear.friction[i]), 0).real();
        slow.friction[i].f_v -= at_rest[i];
    }
    LatePlant late{loop_plant(joint, slow, velocity), {}, {}};
    if (linear.rational()) return late;
    const auto states = late.prompt.A.rows();
    LinearJoint open = opened(joint, linear);
    for (int i = 0; i < open.bodies; ++i) {
        if (open.friction[i].rational()) continue;
        const LinearFriction only = late_part(open.friction[i]);
        double memory = only.table ? only.table->duration() : 0;
        std::vector<LateFriction::Delay> delays{{-at_rest[i], 0}};
        for (const auto& d : only.delays) {
            memory = std::max(memory, d.time);
            delays.push_back({d.weight, d.time});
        }
        Eigen::VectorXd push = Eigen::VectorXd::Zero(states);
        push.head(open.states()) = rates_per_force(open, i);
        late.friction.push_back({push, Eigen::RowVectorXd::Unit(states, open.bodies + i),
                                 [only, still = at_rest[i]](Complex s) { return transfer(only, s) - still; }, delays,
                                 memory, only.table == nullptr});
    }
    open.friction[0].f_v += actuation(joint, velocity, steady_effort(joint, velocity)).drag;
    late.roots_right_of = [open](double sigma) { return roots_right_of(open, sigma); };
    return late;
}

}  // namespace

std::optional<RealLoop> real_loop(const Joint& joint, const LinearJoint& linear, double velocity, TurnedGain turned)
{
    if (!remembers_little(joint)) return {};
    const bool wired_back = joint.actuator.effort_gain < 0 && joint.control.k_p < 0;
    const auto gains = split(without_stopped_integral(joint, velocity), velocity, turned, wired_back ? -1 : 1);
    if (!gains) return {};
    const auto plant = late_plant(joint, linear, velocity);
    if (!plant.prompt.A.allFinite() || !plant.prompt.B.allFinite()) return {};
    const double lag = joint.actuator.lag, delay = joint.dead_time(), period = joint.control.period;
    const auto& v = joint.control.velocity_estimate;
    if (loop_kind(joint) != LoopKind::sampled)
        return RealLoop{late_loop(plant, delay, v.tau, lag, gains->base, gains->turned), gains->gain, gains->per_gain,
                        gains->at_none};
    const LoopTiming timing{period, delay, v.tau, static_cast<int>(v.average), v.form == EstimateForm::exact};
    if (!plant.friction.empty() || delay > most_ticks_in_matrix * period) {
        if (auto loop = late_sampled_loop(plant, timing, lag, gains->base, gains->turned))
            return RealLoop{std::move(*loop), gains->gain, gains->per_gain, gains->at_none};
        if (!plant.friction.empty()) return {};
    }
    return RealLoop{sampled_loop(plant.prompt, timing, gains->base, gains->turned), gains->gain, gains->per_gain,
                    gains->at_none};
}

double growth(const RealLoop& loop)
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop)) return sampled_growth(*sampled, loop.gain);
    return late_growth(std::get<LateLoop>(loop.loop), loop.gain);
}

double side(const RealLoop& loop)
{
    const auto* late = std::get_if<LateLoop>(&loop.loop);
    return late ? late_side(*late, loop.gain) : growth(loop);
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
    const auto& late = std::get<LateLoop>(loop.loop);
    auto axis = axis_crossings(late);
    found.stable = stable_gains(late, axis, loop.gain);
    found.crossings = std::move(axis.crossings);
    found.doubtful = std::move(axis.doubtful);
    found.searched_to = axis.searched_to;
    report(loop, found);
    take_endless(found);
    return found;
}

}  // namespace stickslip
