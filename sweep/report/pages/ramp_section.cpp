#include "sweep/report/pages/comparison_section.h"

#include "sweep/report/figures/line_figure.h"
#include "sweep/report/pages/gain_words.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

Section ramp_section(const Joint& joint, const LinearDetails& details)
{
    const GainWords words{units_of(joint)};
    Section section{"ramps",
                    "Force ramps through a spring",
                    "Armstrong's experiment (§5): the force ramps at a constant rate r through a spring, so that the "
                    "joint slides at V_{0} = r/k. A stiffer spring gives a smaller velocity, and above the critical "
                    "stiffness a stable one.",
                    {},
                    {}};
    const double rate = details.ramp_rate;
    LineChart chart;
    chart.title = "Stiffness that a ramp needs";
    chart.fixed = "k_{v} = " + words.damping(joint.control.k_v);
    chart.x_label = axis_label("rate of force r", Quantity::effort_rate, words.units);
    chart.y_label = axis_label("k_{p} at the boundary", Quantity::position_gain, words.units);
    chart.x_log = chart.y_log = true;
    std::string finding;
    for (const bool memory : {true, false}) {
        const auto& springs = (*details.ramps)[!memory];
        LineChart::Line lower{memory ? "with memory, stable above" : "velocity-only model, stable above",
                              springs.above.x, springs.above.y, !memory},
            upper{memory ? "with memory, stable below" : "velocity-only model, stable below", springs.below.x,
                  springs.below.y, !memory};
        const auto drawn = [](const LineChart::Line& l) {
            return std::any_of(l.y.begin(), l.y.end(), [](double y) { return !std::isnan(y); });
        };
        for (auto* line : {&lower, &upper})
            if (drawn(*line)) chart.lines.push_back(std::move(*line));
        finding += (finding.empty() ? "At this ramp of " + with_unit(rate, Quantity::effort_rate, words.units) +
                                          ", springs slide smoothly with memory for k_{p} "
                                    : "; in the velocity-only model ") +
                   words.gains(springs.here, Quantity::position_gain);
    }
    if (chart.lines.empty()) {
        section.text += " " + finding + ".";
        return section;
    }
    chart.x_marks.emplace_back("here", rate);
    section.figures.push_back(line_figure("ramp-springs", std::move(chart), finding + ".",
                                          "Ends of the stable springs over the rate of force, searched three decades "
                                          "to either side of the joint's own spring; V_{0} = r/k_{p} at every point."));
    return section;
}

}  // namespace stickslip
