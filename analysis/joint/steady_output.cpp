#include "analysis/joint/steady_output.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// k_p and the push towards the set point together.
double error_that_gives(const Control& control, double output, double velocity)
{
    const auto& f = control.feed_forward;
    const double k_p = gains_of(control).k_p;
    if (!f.by_error()) return output / k_p;
    const double full = f.coulomb * f.fade(velocity, velocity < 0 ? -1 : 1).value;
    const double within = f.coulomb_width > 0 ? output / (k_p + full / f.coulomb_width) : infinity;
    if (std::abs(within) <= f.coulomb_width) return within;
    const double beyond = (output - std::copysign(full, output / k_p)) / k_p;
    return beyond * output / k_p > 0 ? beyond : not_set;
}

}  // namespace

SteadyOutput steady_output(const Control& control, double command, double rate, double velocity)
{
    const auto& f = control.feed_forward;
    const bool cascade = control.structure == Structure::cascade;
    const bool integrates = (cascade ? velocity_integral_gain(control) : control.k_i) != 0;
    const double lost = velocity_error(control, rate, velocity);
    const double needed = command - (f.by_error() ? 0 : f.push(rate, velocity, 0));
    const double wanted = cascade && integrates ? needed : needed - gains_of(control).k_v * lost;
    SteadyOutput steady;
    if (integrates) steady.held = std::clamp(wanted, -control.integral_limit, control.integral_limit);
    const double left = wanted - steady.held;
    steady.at_limit = integrates && std::abs(wanted) > control.integral_limit;
    if (cascade && integrates)
        steady.error = ((left == 0 ? 0 : left / control.velocity_gain) - lost) / control.position_gain;
    else if (left != 0 || !integrates)
        steady.error = error_that_gives(control, left, velocity);
    if (steady.error != 0) steady.error += std::copysign(control.dead_zone, steady.error);
    return steady;
}

}  // namespace stickslip
