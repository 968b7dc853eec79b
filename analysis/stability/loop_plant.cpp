// The mechanism under a real loop: its matrices with the actuator, and what limits leave of steady sliding.
#include <algorithm>
#include <cmath>

#include "analysis/joint/drive.h"
#include "analysis/joint/steady_output.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/split_gains.h"
#include "analysis/stability/steady.h"

namespace stickslip {

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
    if (limited && steady.reason == Reason::none && !limits_leave(joint, steady.slides_at))
        steady.reason = Reason::limit_too_low;
    return steady;
}

}  // namespace stickslip
