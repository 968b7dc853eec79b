#include "sweep/report/figures/vmin_figure.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

Figure vmin_figure(const Joint& joint, const LinearDetails& details)
{
    const Units units = units_of(joint);
    const auto [low, high] = searched_speeds(details.study);
    LineChart chart;
    chart.title = "Minimum stable velocity V_{min}";
    chart.x_label = axis_label("position gain k_{p}", Quantity::position_gain, units);
    chart.y_label = axis_label(joint.control.V0 < 0 ? "V_{min}, backwards" : "V_{min}", Quantity::velocity, units);
    chart.x_log = chart.y_log = true;
    std::string slowest, said;
    auto lines = details.least_velocities;
    std::ranges::sort(lines, {}, &LeastVelocities::k_v);
    for (const auto& line : lines) {
        const auto gain = with_unit(line.k_v, Quantity::velocity_gain, units);
        const std::string from = std::isnan(line.here) ? "sliding at the highest velocity searched is unstable"
                                 : line.here == low    ? "all searched velocities are stable"
                                                       : "sliding is stable from " +
                                                          with_unit(line.here, Quantity::velocity, units) + " upwards";
        slowest += (from == said ? ", " : (slowest.empty() ? "" : "; ") + from + " with k_{v} = ") + gain;
        said = from;
        const auto& y = line.over_k_p.y;
        if (std::any_of(y.begin(), y.end(), [](double v) { return !std::isnan(v); }))
            chart.lines.push_back({"k_{v} = " + gain, line.over_k_p.x, y});
    }
    chart.x_marks.emplace_back("here", joint.control.k_p);
    return line_figure("v-min", std::move(chart), "At this position gain " + slowest + ".",
                       "From V_{min} upwards every velocity slides smoothly, with memory, searched " +
                           range_text(low, high, Quantity::velocity, units) +
                           ": the limit of position resolution and, times the stiffness of the contact, of force "
                           "resolution (§6). A line at the lower edge: all searched velocities are stable; no line: "
                           "sliding at the highest is unstable.");
}

}  // namespace stickslip
