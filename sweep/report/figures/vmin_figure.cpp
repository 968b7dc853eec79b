#include "sweep/report/figures/vmin_figure.h"

#include "analysis/results/text.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"
#include "sweep/words/line_figure.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Velocity gains worth a line: the joint's own, and parts and multiples of what velocity alone asks for here.
std::vector<double> shown_gains(const Joint& joint, const LinearStudy& study)
{
    const double asked = study.comparison.k_v_demanded_velocity_only();
    const double own = joint.control.k_v, unit = asked > 0 ? asked : std::abs(own);
    std::vector<double> gains{own};
    for (const double k_v : {unit / 2, unit, 2 * unit})
        if (std::abs(k_v - own) > 1e-3 * unit) gains.push_back(k_v);
    return gains;
}

}  // namespace

Figure vmin_figure(const Joint& given, const LinearStudy& study)
{
    const auto motion = given.mechanism.motion;
    const bool rational = linear_joint(given, commanded_velocity(given)).rational();
    const int gains = rational ? 61 : 31, scan = rational ? 60 : 20;
    const auto [low, high] = study.velocities;
    Joint joint = given;
    LineChart chart;
    chart.title = "Minimum stable velocity V_{min}";
    chart.x_label = axis_label("position gain k_{p}", Quantity::stiffness, motion);
    chart.y_label = axis_label("V_{min}", Quantity::velocity, motion);
    chart.x_log = chart.y_log = true;
    const auto k_p = log_steps(given.control.k_p / 30, given.control.k_p * 30, gains);
    std::string slowest, said;
    for (const double k_v : shown_gains(given, study)) {
        joint.control.k_v = k_v;
        const std::string name = "k_{v} = " + with_unit(k_v, Quantity::damping, motion);
        LineChart::Line line{name, k_p, {}};
        const auto least = [&, &low = low, &high = high](double k) {
            joint.control.k_p = k;
            return stable_velocities(joint, low, high, Theory::state_variable, scan).all_above;
        };
        for (const double k : k_p) line.y.push_back(least(k));
        if (rational) smooth(line, least, 0.25, 5);
        joint.control.k_p = given.control.k_p;
        const double here = stable_velocities(joint, low, high, Theory::state_variable, 2 * scan).all_above;
        const std::string from =
            std::isnan(here) ? "no velocity is stable up to the highest searched"
            : here == low    ? "all searched velocities are stable"
                             : "sliding is stable from " + with_unit(here, Quantity::velocity, motion) + " upwards";
        const bool first = slowest.empty(), as_before = from == said;
        slowest += (as_before ? ", " : (first ? "" : "; ") + from + " with k_{v} = ") +
                   with_unit(k_v, Quantity::damping, motion);
        said = from;
        const bool drawn = std::any_of(line.y.begin(), line.y.end(), [](double v) { return !std::isnan(v); });
        if (drawn) chart.lines.push_back(std::move(line));
    }
    chart.x_marks.emplace_back("here", given.control.k_p);
    return line_figure("v-min", std::move(chart), "At this position gain " + slowest + ".",
                       "From V_{min} upwards every velocity slides smoothly, with memory, searched from " +
                           with_unit(low, Quantity::velocity, motion) + " to " +
                           with_unit(high, Quantity::velocity, motion) +
                           ": the limit of position resolution and, times the stiffness of the contact, of force "
                           "resolution (§6). A line at the lower edge: all searched velocities are stable; no line: "
                           "stick-slip up to the highest.");
}

}  // namespace stickslip
