#include "analysis/diagnosis/outcomes/side.h"

#include "analysis/joint/gains.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Spring force and velocity.
struct State {
    double force, velocity;
};

/// m v̇ = F + k_v (V_0 − v) − f(v), Ḟ = k_p (V_0 − v)
struct Slide {
    const Joint& joint;
    double at_rest;  ///< friction of the slowest sliding

    State rate(const State& s) const
    {
        const auto& c = joint.control;
        const double friction = s.velocity > 0 ? steady_force(joint.friction, s.velocity) : at_rest;
        return {c.k_p * (c.V0 - s.velocity),
                (s.force + c.k_v * (c.V0 - s.velocity) - friction) / joint.mechanism.inertia};
    }
};

State advanced(const State& s, double h, const State& rate)
{
    return {s.force + h * rate.force, s.velocity + h * rate.velocity};
}

double linear_measure(const Joint& joint)
{
    return growth_rate(joint);
}

double release_measure(const Joint& joint)
{
    return -least_velocity_after_release(joint) / joint.control.V0;
}

/// measure / |∂ measure / ∂ ln(k_p, k_v, V_0)|
double distance(const Joint& given, double (*measure)(const Joint&))
{
    const double value = measure(given);
    if (!std::isfinite(value) || value == 0) return value;
    Joint joint = given;
    double squares = 0;
    // roots of a delay are slow to find: its windows of stiffness alone nearly give the distance
    const bool late = std::holds_alternative<TimeLag>(joint.friction.law);
    double* const stiffness = &stated_position_gain(joint.control);
    for (double* setting : {stiffness, &stated_velocity_gain(joint.control), &joint.control.V0}) {
        if (*setting == 0 || (late && setting != stiffness)) continue;
        constexpr double step = 1e-3;  // numerical: of a difference
        const double was = *setting;
        *setting = was * (1 + step);
        const double slope = (measure(joint) - value) / step;
        *setting = was;
        if (std::isfinite(slope)) squares += slope * slope;
    }
    return std::clamp(value / std::max(std::sqrt(squares), std::abs(value) / farthest), -farthest, farthest);
}

}  // namespace

double least_velocity_after_release(const Joint& joint)
{
    const auto& c = joint.control;
    const double mass = joint.mechanism.inertia, omega = std::sqrt(c.k_p / mass);
    const Slide slide{joint, steady_force(joint.friction, 1e-12 * c.V0)};
    const double breakaway = std::max(static_force(joint.friction.law), slide.at_rest);
    const double size = std::abs(slide.at_rest - steady_force(joint.friction, c.V0)) + (breakaway - slide.at_rest) +
                        mass * omega * c.V0;
    constexpr double tolerance = 1e-5, turns = 12, settled = 1e-3;  // numerical: of the integration
    State s{breakaway - c.k_v * c.V0, 0};
    // an overdamped mass creeps up to V_0 and never turns
    const double longest = (turns * 6.3 + 5 * std::abs(c.k_v) / (mass * omega)) / omega;
    double h = 1e-3 / omega, t = 0;
    State k1 = slide.rate(s);
    bool rising = true;
    for (int step = 0; step < 20000 && t < longest; ++step) {
        // Bogacki and Shampine's pair of orders 3 and 2
        const State k2 = slide.rate(advanced(s, h / 2, k1)), k3 = slide.rate(advanced(s, 3 * h / 4, k2));
        const State next{s.force + h * (2 * k1.force + 3 * k2.force + 4 * k3.force) / 9,
                         s.velocity + h * (2 * k1.velocity + 3 * k2.velocity + 4 * k3.velocity) / 9};
        const State k4 = slide.rate(next);
        const auto error = [&](double a, double b, double d, double e) {
            return h * std::abs(-5 * a / 72 + b / 12 + d / 9 - e / 8);
        };
        const double wrong = std::max(error(k1.force, k2.force, k3.force, k4.force) / size,
                                      error(k1.velocity, k2.velocity, k3.velocity, k4.velocity) * mass * omega / size);
        if (wrong > tolerance) {
            h *= std::clamp(0.9 * std::cbrt(tolerance / wrong), 0.2, 0.9);
            continue;
        }
        if (rising && k1.velocity > 0 && k4.velocity < 0) rising = false;
        if (!rising && k4.velocity >= 0) {
            // the velocity is a cubic between the two steps; its least value lies where its rate, nearly a line, is 0
            const double u = k1.velocity / (k1.velocity - k4.velocity);
            return s.velocity + h * k1.velocity * u / 2;
        }
        s = next, k1 = k4, t += h;
        if (std::abs(s.velocity - c.V0) < settled * c.V0 && std::abs(k1.velocity) < settled * omega * c.V0) break;
        h *= std::clamp(0.9 * std::cbrt(tolerance / std::max(wrong, 1e-12)), 0.5, 3.0);
    }
    return c.V0;
}

double distance_to_stick_slip(const Joint& joint)
{
    const double linear = distance(joint, linear_measure);
    const auto& law = joint.friction.law;
    // nothing drops when a Coulomb joint breaks loose
    if (states(joint.friction) > 0 || std::holds_alternative<TimeLag>(law) ||
        std::holds_alternative<CoulombViscous>(law))
        return linear;
    const double released = distance(joint, release_measure);
    return std::isfinite(linear) ? std::max(linear, released) : released;
}

}  // namespace stickslip::gap
