#include "analysis/simulation/set_point/sliding_loop.h"

#include "analysis/joint/gains.h"
#include "analysis/simulation/set_point/regulator.h"
#include "analysis/simulation/set_point/set_point_load.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

bool acts_late(const Joint& joint)
{
    const auto& c = joint.control;
    return is_set(c.period) || joint.dead_time() > 0 || joint.actuator.lag > 0 ||
           (c.velocity_estimate.tau > 0 && gains_of(c).k_v != 0);
}

double sliding_growth(const Joint& given, double viscous)
{
    constexpr double some_speed = 1e-9;  // the loop is the same at every one
    Joint joint = given;
    auto& c = joint.control;
    c.V0 = some_speed;
    c.force_rate = not_set;
    c.contact_stiffness += gravity_stiffness(given);
    c.effort_limit = c.integral_limit = c.integral_band = infinity;
    c.dead_zone = 0;
    c.feed_forward = {};
    c.dither = {};
    joint.actuator.limit = infinity;
    joint.load = {};
    joint.friction = {};
    joint.friction.law = CoulombViscous{0, viscous};
    return growth_rate(joint);
}

double stable_integral_gain(const Joint& given, double viscous)
{
    constexpr double least = 1e-6, most = 100, step = 1.3, close = 1e-6;  // of Routh's
    const auto regulator = regulator_of(given);
    const double damping = regulator.k_v + regulator.drag + viscous;
    const double routh = damping * given.control.k_p / regulator.inertia;
    if (!acts_late(given)) return routh;
    Joint joint = given;
    const auto stable = [&](double k_i) {
        joint.control.k_i = k_i;
        return sliding_growth(joint, viscous) < 0;
    };
    double low = least * routh, high = low;
    if (!(routh > 0) || !stable(low)) return 0;
    while (stable(high)) {
        low = high, high *= step;
        if (high > most * routh) return low;
    }
    while (high - low > close * high) {
        const double middle = 0.5 * (low + high);
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace stickslip
