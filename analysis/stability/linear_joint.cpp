#include "analysis/stability/linear_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip {

int LinearJoint::states() const
{
    int sum = 2 * (bodies + neighbour.size);
    for (int i = 0; i < bodies; ++i) sum += friction[i].states;
    return sum;
}

bool LinearJoint::rational() const
{
    for (int i = 0; i < bodies; ++i)
        if (!friction[i].rational()) return false;
    return true;
}

Chain chain_of(const Joint& joint)
{
    const auto& m = joint.mechanism;
    Chain chain;
    const auto body = [&](double inertia, const Friction& friction, double ratio) {
        chain.body[chain.bodies++] = {inertia * ratio * ratio, &friction, ratio};
    };
    switch (m.model) {
        case Model::single_mass:
            body(m.inertia, joint.friction, 1);
            break;
        case Model::two_mass:
            body(m.motor_inertia, joint.frictions.motor, m.transmission.ratio);
            body(m.link_inertia, joint.frictions.link, 1);
            chain.stiffness[0] = m.transmission.stiffness;
            chain.cubic[0] = m.transmission.cubic_stiffness;
            chain.damping[0] = m.transmission.damping;
            break;
        case Model::three_mass:
        case Model::lever: {
            const bool lever = m.model == Model::lever;
            const double middle = m.transmission_link.ratio, motor = m.motor_transmission.ratio * middle;
            // a lever's first spring is at the motor's side, any other at its own joint side
            const double side = lever ? motor : middle;
            body(m.motor_inertia, joint.frictions.motor, motor);
            body(lever ? m.transmission_inertia / (m.lever_arm * m.lever_arm) : m.transmission_inertia,
                 joint.frictions.transmission, middle);
            body(m.link_inertia, joint.frictions.link, 1);
            chain.stiffness = {side * side * m.motor_transmission.stiffness, m.transmission_link.stiffness};
            chain.cubic = {std::pow(side, 4) * m.motor_transmission.cubic_stiffness,
                           m.transmission_link.cubic_stiffness};
            chain.damping = {side * side * m.motor_transmission.damping, m.transmission_link.damping};
            break;
        }
    }
    const auto& c = joint.control;
    if (c.kind == ControlKind::force)
        for (int i = chain.bodies - 1; i > 0; --i)
            chain.body[i - 1].speed = chain.body[i].speed + (c.k_p + c.contact_stiffness) / chain.stiffness[i - 1];
    return chain;
}

namespace {

/// Leaves out delays that no root notices: beside inertia, one as weak as this damps or feeds a root of |s| τ = 1 by
/// less than rounding. A falling curve fades away like that, and its last digits would still be searched for crossings.
LinearFriction noticed(LinearFriction friction, double inertia)
{
    constexpr double roundings = 32;
    DelayList kept;
    for (const auto& d : friction.delays)
        if (std::abs(d.weight) * d.time > roundings * std::numeric_limits<double>::epsilon() * inertia)
            kept.push_back(d);
    friction.delays = kept;
    return friction;
}

}  // namespace

namespace {

/// σ' = N(s) x, N = n0 + n1 s + n2 s², of friction μ σ whose state a change of σ takes α σ' out of (Linker & Dieterich
/// 1992; Dupont & Bapna 1994): μ N − α N s/(s − λ) beside the joint. The first part is a stiffness, a damping and an
/// inertia; N/(s − λ) = n2 s + (n1 + n2 λ) + (n0 + n1 λ + n2 λ²)/(s − λ) puts the second into inertia, direct effect
/// and the weight of the state. Of several states each takes its share of the whole memory.
void press(LinearJoint& linear, const NormalLoad& load, double mu)
{
    const int link = linear.link();
    auto& f = linear.friction[link];
    const double n0 = load.displacement, n1 = load.velocity, n2 = load.acceleration;
    linear.inertia[link] += mu * n2;
    f.f_v += mu * n1;
    linear.contact[link] += mu * n0;
    const double whole = kernel_integral(f);
    if (load.alpha == 0 || f.states == 0 || whole == 0) return;
    for (int i = 0; i < f.states; ++i) {
        const double lambda = f.lambda[i], share = f.weight(i) / -lambda / whole, taken = load.alpha * share;
        if (taken == 0) continue;
        linear.inertia[link] -= taken * n2;
        linear.state_inertia -= taken * n2;
        linear.state_slope += taken * n0 / lambda;
        f.f_v -= taken * (n1 + n2 * lambda);
        // −taken (n0 + n1 λ + n2 λ²)/(s − λ) joins h b/(s − λ)
        f.h[i] -= taken * (n0 + n1 * lambda + n2 * lambda * lambda) / f.b[i];
    }
}

}  // namespace

double friction_per_load(const Joint& joint, double V)
{
    if (is_set(joint.normal.mu)) return joint.normal.mu;
    const Friction& friction = joint.mechanism.model == Model::single_mass ? joint.friction : joint.frictions.link;
    return std::abs(steady_force(friction, V)) / friction.normal_load;
}

std::array<double, max_bodies> carried_efforts(const Joint& joint, double V, double load)
{
    const Chain chain = chain_of(joint);
    std::array<double, max_bodies> effort{};
    double next = -load;
    for (int i = chain.bodies - 1; i >= 0; --i) {
        const auto& body = chain.body[i];
        const double own = next + body.ratio * steady_force(*body.friction, body.velocity(V));
        const double mu = body.friction->load_coefficient * (V < 0 ? -1 : 1);
        if (i == 0 && chain.bodies > 1)
            effort[0] = own + mu * std::abs(next);  // loaded by the spring behind it
        else
            effort[i] = own / (1 - (own < 0 ? -mu : mu));
        next = effort[i];
    }
    return effort;
}

namespace {

/// Friction that grows with the effort which a spring carries, by its own coefficient or by a normal load from it.
void load_by_effort(LinearJoint& linear, const Joint& joint, const Chain& chain, double V)
{
    bool any = joint.normal.from_load != 0;
    for (int i = 0; i < chain.bodies; ++i) any |= chain.body[i].friction->load_coefficient != 0;
    if (!any) return;
    const auto effort = carried_efforts(joint, V, joint.load.constant);
    for (int i = 0; i < chain.bodies; ++i) {
        double per_effort = chain.body[i].friction->load_coefficient;
        if (i == linear.link() && joint.normal.from_load != 0)
            per_effort += joint.normal.from_load * friction_per_load(joint, V);
        const bool along = effort[static_cast<std::size_t>(spring_of(i)) + 1] * V > 0;
        linear.carried[i] = along ? per_effort : -per_effort;
    }
}

/// A spring that hardens counts with its slope at what it carries in steady sliding.
void stretch_springs(LinearJoint& linear, const Joint& joint, const Chain& chain, double V)
{
    if (std::ranges::all_of(chain.cubic, [](double c) { return c == 0; })) return;
    const auto effort = carried_efforts(joint, V, joint.load.constant);
    for (int i = 0; i + 1 < chain.bodies; ++i) {
        const Spring spring = chain.spring(i);
        linear.stiffness[i] = spring.slope(spring.stretch(effort[i + 1]));
    }
}

}  // namespace

LinearJoint linear_joint(const Joint& joint, double V)
{
    const auto& c = joint.control;
    const Chain chain = chain_of(joint);
    LinearJoint linear;
    linear.bodies = chain.bodies;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& body = chain.body[i];
        linear.inertia[i] = body.inertia;
        linear.friction[i] = reflected(linearise(*body.friction, body.velocity(V)), body.ratio);
    }
    if (joint.normal.moves()) press(linear, joint.normal, friction_per_load(joint, V));
    if (chain.bodies == 1) {
        // friction that grows with the transmitted effort carries a share μ of the loop's force away
        const double share = 1 - joint.friction.load_coefficient;
        for (double* whole : {&linear.inertia[0], &linear.contact[0], &linear.state_inertia, &linear.state_slope})
            *whole /= share;
        linear.friction[0] = scaled(std::move(linear.friction[0]), 1 / share);
    } else {
        load_by_effort(linear, joint, chain, V);
    }
    for (const auto& n : joint.neighbour) linear.neighbour.push_back({n.inertia, n.coupling, n.k_v, n.k_p});
    for (int i = 0; i < chain.bodies; ++i)
        if (linear.friction[i].delays.size > 0)
            linear.friction[i] = noticed(std::move(linear.friction[i]), linear.inertia[i]);
    linear.stiffness = chain.stiffness;
    linear.damping = chain.damping;
    stretch_springs(linear, joint, chain, V);
    linear.k_p = c.k_p;
    linear.k_v = c.k_v;
    const int link = linear.link();
    linear.contact[link] += c.contact_stiffness;
    if (c.kind == ControlKind::force) {
        linear.measured = link;
        linear.actuated[link] = 1;
        linear.actuated[0] += c.force_gain;
        linear.contact[0] += c.force_gain * c.contact_stiffness;
    } else {
        linear.measured = c.feedback == Feedback::link ? link : 0;
        linear.actuated[0] = 1;
    }
    return linear;
}

LinearJoint velocity_only(LinearJoint joint)
{
    for (int i = 0; i < joint.bodies; ++i) {
        LinearFriction curve;
        curve.f_v = steady_slope(joint.friction[i]);
        joint.friction[i] = curve;
    }
    joint.inertia[joint.link()] -= joint.state_inertia;
    joint.friction[joint.link()].f_v -= joint.state_slope;
    joint.state_inertia = joint.state_slope = 0;
    return joint;
}

}  // namespace stickslip
