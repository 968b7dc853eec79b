#include "tests/oracles/motion.h"

#include <stdexcept>

#include "analysis/stability/steady.h"

namespace stickslip {

JointMotion::JointMotion(const Joint& joint) : joint_(joint), chain_(chain_of(joint_))
{
    const auto sliding = steady_sliding(joint_);
    if (sliding.reason != Reason::none)
        throw std::invalid_argument("the joint cannot slide steadily at its commanded velocity");
    if (joint_.friction.load_coefficient != 0)
        throw std::invalid_argument(
            "these equations of motion have no friction that grows with the transmitted effort");
    V0_ = sliding.velocity;
    const auto& c = joint_.control;
    const int link = bodies() - 1;
    const bool force = c.kind == ControlKind::force;

    size_ = 2 * bodies();
    // what spring i − 1 has to carry at t = 0: the friction of all bodies behind it, the finger's damper, less the load
    std::array<double, max_bodies> carried{};
    for (int i = 0; i < bodies(); ++i) {
        const auto& body = chain_.body[i];
        first_state_[i] = size_;
        size_ += states(*body.friction);
        const double f = body.ratio * steady_force(*body.friction, body.velocity(V0_));
        for (int k = 0; k <= i; ++k) carried[k] += f;
    }
    const double finger = force ? c.k_v * V0_ : 0;
    for (int i = 0; i < bodies(); ++i) carried[i] += finger - joint_.load.constant;
    for (int i = link; i > 0; --i) {
        const double slip = (chain_.body[i - 1].speed - chain_.body[i].speed) * V0_;
        offset_[i - 1] = offset_[i] + (carried[i] - chain_.damping[i - 1] * slip) / chain_.stiffness[i - 1];
    }
    if (force) {
        feedforward_ = carried[0] + c.force_gain * finger;
        feedforward_rate_ = (1 + c.force_gain) * (c.k_p + c.contact_stiffness) * V0_;
        return;
    }
    // the command leads the measured body by what the loop has to carry
    const int measured = c.feedback == Feedback::link ? link : 0;
    const double shift = -carried[0] / c.k_p - offset_[measured];
    for (int i = 0; i < bodies(); ++i) offset_[i] += shift;
}

std::vector<double> JointMotion::steady(double t) const
{
    std::vector<double> y(static_cast<std::size_t>(size_));
    for (int i = 0; i < bodies(); ++i) {
        const auto& body = chain_.body[i];
        y[i] = offset_[i] + body.speed * V0_ * t;
        y[bodies() + i] = body.speed * V0_;
        const States theta = steady_state(*body.friction, body.velocity(V0_));
        std::copy_n(theta.begin(), states(*body.friction), y.begin() + first_state_[i]);
    }
    return y;
}

double JointMotion::friction(int i, const double* y, double* state_rates) const
{
    const auto& body = chain_.body[i];
    const int count = states(*body.friction);
    States theta{};
    std::copy_n(y + first_state_[i], count, theta.begin());
    const auto r = respond(*body.friction, body.ratio * y[bodies() + i], theta);
    if (state_rates) std::copy_n(r.rate.begin(), count, state_rates + first_state_[i]);
    // friction that grows with the transmitted effort carries a share μ of it away (steady_sliding allows one body
    // only)
    return body.ratio * r.force;
}

double JointMotion::spring_force(int i, const double* y) const
{
    const double* v = y + bodies();
    return -chain_.stiffness[i] * (y[i] - y[i + 1]) - chain_.damping[i] * (v[i] - v[i + 1]);
}

std::array<double, max_bodies> JointMotion::outer_forces(double t, const double* y) const
{
    const auto& c = joint_.control;
    const int link = bodies() - 1;
    const double* v = y + bodies();
    std::array<double, max_bodies> force{};
    force[link] += joint_.load.constant;
    if (c.kind == ControlKind::force) {
        const double finger = (c.k_p + c.contact_stiffness) * y[link] + c.k_v * v[link];
        force[link] -= finger;
        force[0] += feedforward_ + feedforward_rate_ * t - c.force_gain * finger;
    } else {
        const int measured = c.feedback == Feedback::link ? link : 0;
        force[0] += c.k_p * (V0_ * t - y[measured]) + c.k_v * (V0_ - v[measured]);
        force[link] -= c.contact_stiffness * (y[link] - offset_[link] - V0_ * t);
    }
    return force;
}

void JointMotion::rate(double t, const double* y, double* dydt, double disturbance) const
{
    const int n = bodies();
    auto force = outer_forces(t, y);
    force[n - 1] += disturbance;
    for (int i = 0; i + 1 < n; ++i) {
        const double spring = spring_force(i, y);
        force[i] += spring;
        force[i + 1] -= spring;
    }
    for (int i = 0; i < n; ++i) {
        const double f = friction(i, y, dydt);
        dydt[i] = y[n + i];
        dydt[n + i] = (force[i] - f) / chain_.body[i].inertia;
    }
}

double JointMotion::energy(const double* y) const
{
    double sum = 0;
    for (int i = 0; i < bodies(); ++i) sum += chain_.body[i].inertia * y[bodies() + i] * y[bodies() + i] / 2;
    for (int i = 0; i + 1 < bodies(); ++i) sum += chain_.stiffness[i] * (y[i] - y[i + 1]) * (y[i] - y[i + 1]) / 2;
    return sum;
}

double JointMotion::dissipation(const double* y) const
{
    const double* v = y + bodies();
    double sum = 0;
    for (int i = 0; i < bodies(); ++i) sum += friction(i, y, nullptr) * v[i];
    for (int i = 0; i + 1 < bodies(); ++i) sum += chain_.damping[i] * (v[i] - v[i + 1]) * (v[i] - v[i + 1]);
    return sum;
}

double JointMotion::input(double t, const double* y) const
{
    const auto force = outer_forces(t, y);
    double sum = 0;
    for (int i = 0; i < bodies(); ++i) sum += force[i] * y[bodies() + i];
    return sum;
}

}  // namespace stickslip
