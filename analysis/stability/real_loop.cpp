#include "analysis/stability/real_loop.h"

#include <algorithm>
#include <numbers>

#include "analysis/joint/gains.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/steady.h"

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

LoopPlant plant_of(const Joint& joint, const LinearJoint& linear, double velocity)
{
    const auto acts = actuation(joint, velocity, steady_effort(joint));
    const LinearJoint open = opened(joint, linear);
    const int n = open.bodies, states = open.states(), lag = joint.actuator.lag > 0;
    LoopPlant plant;
    plant.A = Eigen::MatrixXd::Zero(states + lag, states + lag);
    plant.A.topLeftCorner(states, states) = state_matrix(open);
    const Eigen::VectorXd per_effort = rates_per_effort(open);
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
        plant.C[open.measured] = acts.scale;
        plant.C_v[n + open.measured] = acts.scale;
    } else {
        plant.C[open.link()] = joint.control.k_p + joint.control.contact_stiffness;
        plant.C[n + open.link()] = joint.control.k_v;
    }
    return plant;
}

struct SplitGains {
    LoopGains base, turned;
    double gain;
};

/// All gains of the loop, in the terms of its controller.
LoopGains all_gains(const Joint& joint)
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

std::optional<SplitGains> split(const Joint& joint, TurnedGain turned)
{
    const auto& c = joint.control;
    LoopGains base = all_gains(joint);
    if (turned == TurnedGain::all) return SplitGains{{}, base, 1};
    if (c.kind == ControlKind::force) return {};
    if (c.structure == Structure::cascade) {
        // the gain of the position loop turns with k_p and k_i together
        if (turned == TurnedGain::k_v) return {};
        const double K_i = velocity_integral_gain(c);
        base.position -= c.velocity_gain * c.position_gain;
        base.integral = 0;
        return SplitGains{base, {c.velocity_gain, 0, K_i, 0}, c.position_gain};
    }
    if (turned == TurnedGain::k_p) {
        base.position = 0;
        return SplitGains{base, {1, 0, 0, 0}, c.k_p};
    }
    base.velocity = 0;
    return SplitGains{base, {0, 1, 0, 0}, c.k_v};
}

std::vector<Interval> stable_intervals_of(const RealLoop& loop, std::vector<Crossing>& crossings,
                                          std::vector<Interval>& doubtful, double& searched_to)
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop)) {
        auto found = circle_crossings(*sampled);
        crossings = std::move(found.crossings);
        doubtful = std::move(found.doubtful);
        return stable_gains(*sampled, crossings, loop.gain);
    }
    const auto& late = std::get<LateLoop>(loop.loop);
    auto found = axis_crossings(late);
    auto stable = stable_gains(late, found, loop.gain);
    crossings = std::move(found.crossings);
    doubtful = std::move(found.doubtful);
    searched_to = found.searched_to;
    return stable;
}

struct SingleGain {
    double k_cr = not_set, omega = not_set;
};

/// One crossing, above which every gain is stable. Ticks and dead time always leave an end above.
SingleGain single_gain(const std::vector<Crossing>& crossings, const std::vector<Interval>& windows)
{
    if (crossings.size() != 1 || windows.size() != 1 || windows[0].low != crossings[0].k_p) return {};
    if (windows[0].high != infinity) return {};
    return {crossings[0].k_p, crossings[0].omega};
}

/// The mechanism slides at V_0 by what the encoder says.
double sliding_velocity(const Joint& joint, double commanded)
{
    return commanded / joint.sensor.position_scale;
}

std::uint8_t code_of(double growth)
{
    return growth < 0 ? 1 : growth == 0 ? verdict_neutral : 0;
}

}  // namespace

double steady_effort(const Joint& joint)
{
    const auto steady = steady_sliding(joint);
    const double share = joint.mechanism.model == Model::single_mass ? 1 - joint.friction.load_coefficient : 1;
    return steady.friction / share - joint.load.constant;
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
    const double v = std::abs(velocity);
    double R = a.resistance, sagging = 0;
    if (a.supply_resistance > 0 && is_set(a.supply_voltage)) {
        // D with effort (R + |D| R_s) = k_t (D U − k_e v)
        const double D = (effort * a.resistance + k_t * a.k_e * v) /
                         (k_t * a.supply_voltage - std::abs(effort) * a.supply_resistance);
        R += std::abs(D) * a.supply_resistance;
        sagging = std::abs(effort) * a.supply_resistance / R / (duty ? 1 : a.supply_voltage);
    }
    acts.gain = (k_t / R * (duty ? a.supply_voltage : 1) - sagging);
    acts.drag = k_t * a.k_e / R;
    return acts;
}

bool limits_leave(const Joint& joint, double velocity)
{
    const auto& a = joint.actuator;
    const auto& c = joint.control;
    if (c.kind == ControlKind::force) return true;
    const double effort = std::abs(steady_effort(joint));
    if (a.kind == ActuatorKind::effort) {
        const double left = a.sag_effort < infinity ? 1 - effort / a.sag_effort : 1;
        return left > 0 && effort <= a.limit && effort / left <= std::abs(a.effort_gain) * c.effort_limit;
    }
    if (effort > a.limit) return false;
    const auto acts = actuation(joint, velocity, effort);
    const double volts = (effort * a.resistance / (a.effort_gain * a.k_t)) + a.k_e * std::abs(velocity);
    const bool duty = a.signal == DriveSignal::duty;
    const double command = duty ? volts / a.supply_voltage : volts;
    const double most = is_set(a.supply_voltage) ? (duty ? 1 : a.supply_voltage) : infinity;
    return acts.gain > 0 && command <= std::min(most, c.effort_limit);
}

std::optional<RealLoop> real_loop(const Joint& joint, const LinearJoint& linear, double velocity, TurnedGain turned)
{
    if (!linear.rational()) return {};
    const auto gains = split(joint, turned);
    if (!gains) return {};
    const auto plant = plant_of(joint, linear, velocity);
    if (!plant.A.allFinite() || !plant.B.allFinite()) return {};
    const auto& c = joint.control;
    if (loop_kind(joint) == LoopKind::sampled) {
        const LoopTiming timing{c.period, c.delay, c.velocity_estimate.tau,
                                static_cast<int>(c.velocity_estimate.average),
                                c.velocity_estimate.form == EstimateForm::exact};
        return RealLoop{sampled_loop(plant, timing, gains->base, gains->turned), gains->gain};
    }
    return RealLoop{late_loop(plant, c.delay, c.velocity_estimate.tau, gains->base, gains->turned), gains->gain};
}

double growth(const RealLoop& loop)
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop)) return sampled_growth(*sampled, loop.gain);
    return late_growth(std::get<LateLoop>(loop.loop), loop.gain);
}

CommandMargins real_margins(const Joint& joint, double commanded)
{
    const double velocity = sliding_velocity(joint, commanded);
    const auto loop = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::all);
    if (!loop) return {};
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop->loop)) return command_margins(*sampled);
    return command_margins(std::get<LateLoop>(loop->loop));
}

void add_margins(const Joint& joint, LinearVerdict& verdict)
{
    if (verdict.steady.reason != Reason::none || joint.control.kind != ControlKind::position) return;
    if (!std::isnan(verdict.state_variable.phase_margin_deg)) return;
    const auto margins = real_margins(joint, verdict.steady.velocity);
    verdict.state_variable.gain_margin_db = margins.gain_db;
    verdict.state_variable.phase_margin_deg = margins.phase_deg;
}

double real_growth(const Joint& joint, double commanded, bool velocity_only_friction)
{
    const double velocity = sliding_velocity(joint, commanded);
    auto linear = linear_joint(joint, velocity);
    if (velocity_only_friction) linear = velocity_only(std::move(linear));
    const auto loop = real_loop(joint, linear, velocity, TurnedGain::all);
    return loop ? growth(*loop) : missing;
}

PointResult real_point(const Joint& joint, double commanded)
{
    const double velocity = sliding_velocity(joint, commanded);
    PointResult point;
    const auto linear = linear_joint(joint, velocity);
    const auto loop = real_loop(joint, linear, velocity, TurnedGain::all);
    if (!loop) {
        point.reason = linear.rational() ? Reason::not_finite : Reason::unsupported;
        return point;
    }
    point.spectral_abscissa = growth(*loop);
    if (!std::isfinite(point.spectral_abscissa)) {
        point.reason = Reason::not_finite;
        return point;
    }
    const auto simple = real_loop(joint, velocity_only(linear), velocity, TurnedGain::all);
    const double simply = simple ? growth(*simple) : missing;
    point.velocity_only_stable = std::isfinite(simply) ? code_of(simply) : verdict_missing;
    point.state_variable_stable = code_of(point.spectral_abscissa);
    if (point.state_variable_stable == verdict_neutral)
        point.region = Region::neutral;
    else if (point.state_variable_stable == 1)
        point.region = point.velocity_only_stable == 1 ? Region::stable : Region::memory_only;
    else
        point.region = point.velocity_only_stable == 1 ? Region::velocity_only : Region::unstable;
    const auto* late = std::get_if<LateLoop>(&loop->loop);
    if (!late || late->delay > 0) return point;
    if (const auto turned = real_loop(joint, linear, velocity, TurnedGain::k_p)) {
        std::vector<Crossing> crossings;
        std::vector<Interval> doubtful;
        double searched_to = infinity;
        const auto windows = stable_intervals_of(*turned, crossings, doubtful, searched_to);
        const auto single = single_gain(crossings, windows);
        point.k_cr = single.k_cr, point.omega = single.omega;
    }
    return point;
}

LinearVerdict real_verdict(const Joint& joint, LinearVerdict verdict)
{
    const double V = sliding_velocity(joint, verdict.steady.velocity);
    const auto linear = linear_joint(joint, V);
    auto& simple = verdict.velocity_only;
    auto& memory = verdict.state_variable;
    simple.slope = memory.f_v = memory.kernel_integral = 0;
    for (int i = 0; i < linear.bodies; ++i) {
        simple.slope += steady_slope(linear.friction[i]);
        memory.f_v += linear.friction[i].f_v;
        memory.kernel_integral += kernel_integral(linear.friction[i]);
    }
    const auto all = real_loop(joint, linear, V, TurnedGain::all);
    if (!all) {
        verdict.steady.reason = linear.rational() ? Reason::not_finite : Reason::unsupported;
        return verdict;
    }
    memory.spectral_abscissa = growth(*all);
    if (!std::isfinite(memory.spectral_abscissa)) {
        verdict.steady.reason = Reason::not_finite;
        return verdict;
    }
    if (const auto* sampled = std::get_if<DiscreteLoop>(&all->loop)) {
        memory.multipliers = multipliers(*sampled, 1);
        for (const Complex& z : memory.multipliers)
            if (std::abs(z) > 0) memory.eigenvalues.push_back(std::log(z) / sampled->period);
        const auto margins = command_margins(*sampled);
        memory.gain_margin_db = margins.gain_db;
        memory.phase_margin_deg = margins.phase_deg;
    } else {
        const auto& late = std::get<LateLoop>(all->loop);
        memory.eigenvalues = roots(late, 1);
        memory.all_eigenvalues = late.delay == 0;
        const auto margins = command_margins(late);
        memory.gain_margin_db = margins.gain_db;
        memory.phase_margin_deg = margins.phase_deg;
    }
    memory.stable = memory.spectral_abscissa < 0;
    memory.neutral = memory.spectral_abscissa == 0;
    if (const auto turned = real_loop(joint, linear, V, TurnedGain::k_p)) {
        memory.stable_intervals = stable_intervals_of(*turned, memory.crossings, memory.doubtful, memory.searched_to);
        memory.k_cr = single_gain(memory.crossings, memory.stable_intervals).k_cr;
    }
    const auto curve = velocity_only(linear);
    if (const auto loop = real_loop(joint, curve, V, TurnedGain::all)) {
        const double rate = growth(*loop);
        simple.stable = rate < 0;
        simple.neutral = rate == 0;
    }
    if (const auto turned = real_loop(joint, curve, V, TurnedGain::k_v)) {
        std::vector<Crossing> crossings;
        std::vector<Interval> doubtful;
        double searched_to = infinity;
        simple.stable_k_v = stable_intervals_of(*turned, crossings, doubtful, searched_to);
        if (!simple.stable_k_v.empty()) simple.k_v_min = simple.stable_k_v.front().low;
    }
    return verdict;
}

}  // namespace stickslip
