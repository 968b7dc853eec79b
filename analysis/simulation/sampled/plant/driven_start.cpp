// Where motions of a driven joint begin: in steady sliding, or at rest.
#include "analysis/numerics/root.h"
#include "analysis/simulation/sampled/plant/driven_joint.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// The velocity V* at which a contact's level holds; NaN for friction without memory.
double level_velocity(const Friction& friction)
{
    if (friction.has_memory()) return friction.memory.V_star;
    return std::visit(
        [](const auto& law) {
            if constexpr (requires { law.f0, law.V_star; })
                return law.V_star;
            else
                return missing;
        },
        friction.law);
}

}  // namespace

DrivenJoint::Steady DrivenJoint::steady(double velocity_asked) const
{
    Steady s{{}, missing};
    auto& y = s.y;
    const int n = bodies();
    double carried = 0, unused;  // by the springs, from the link down
    for (int i = n - 1; i >= 0; --i) {
        const auto& b = body_[i];
        if (i < n - 1) {
            const double stretch = chain_.spring(i).stretch(carried);
            y[i] = y[i + 1] + stretch + (stretch == 0 ? 0 : std::copysign(0.5 * backlash_[i], stretch));
        }
        set_velocity(y.data(), i, velocity_asked);
        const auto theta = steady_state(b.friction, b.ratio * velocity_asked);
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
        carried += b.ratio * steady_force(b.friction, b.ratio * velocity_asked);
        if (i == n - 1) carried -= load(y.data(), &unused, &unused) + contact_force(y.data());
    }
    const double origin = y[measured_];
    for (int i = 0; i < n; ++i) y[i] -= origin;
    const auto& a = joint_.actuator;
    if (n == 1) {
        const double direction = velocity_asked < 0 ? -1 : 1;
        if (joint_.friction.gear.acts())
            carried += direction * joint_.friction.normal_load * gear_level_at_rest(y.data(), direction);
        carried /= 1 - joint_.friction.load_coefficient;
    }
    const double effort = carried / effort_ratio_, v = effort_ratio_ * velocity_asked;
    const auto missed = [&](double command) { return push_of(a, command, a.supply_voltage, v).at(v) - effort; };
    const double sign = a.effort_gain < 0 ? -1 : 1;
    double reach = std::abs(effort / (a.effort_gain == 0 ? 1 : a.effort_gain)) + 1;
    for (int k = 0; k < 60 && !(sign * missed(reach) >= 0 && sign * missed(-reach) <= 0); ++k) reach *= 2;
    const double low = missed(-reach), high = missed(reach);
    if (sign * high >= 0 && sign * low <= 0 && std::isfinite(low) && std::isfinite(high))
        s.command = bracketed_root(missed, -reach, low, reach, high, 1e-16, 1e-300).value;
    if (has_lag()) y[lag_index_] = s.command;
    return s;
}

DrivenState DrivenJoint::at_rest(double x) const
{
    DrivenState y{};
    for (int i = 0; i < bodies(); ++i) {
        const auto& b = body_[i];
        y[i] = x;
        y[bodies() + i] = 0;
        // bristles stand upright; a contact remembers sliding at V*, at which its level holds, since a record says
        // nothing of how long it has aged; a level that follows late is that of rest
        const double slides = level_velocity(b.friction);
        if (std::isnan(slides) && !b.friction.has_lag()) continue;
        auto theta = steady_state(b.friction, std::isnan(slides) ? rest_speed * b.ratio * b.speed : slides);
        if (b.friction.has_lag()) {
            const auto still = steady_state(b.friction, rest_speed * b.ratio * b.speed);
            theta[stickslip::states(b.friction.law)] = still[stickslip::states(b.friction.law)];
        }
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
    }
    return y;
}

}  // namespace stickslip
