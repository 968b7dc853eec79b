#include "sweep/report/figures/disturbance_figure.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"

#include <cmath>

namespace stickslip {

Figure disturbance_figure(const Joint& joint, const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    const Units units = units_of(joint);
    LineChart chart;
    chart.title = "Response to a disturbing force: " + asked.kind;
    chart.fixed =
        is_force_file(asked)
            ? "the file's force times " + plain_number(asked.size)
            : "size " + with_unit(asked.size, asked.kind == "impulse" ? Quantity::impulse : Quantity::effort, units);
    chart.x_label = axis_label("time t", Quantity::time, units);
    chart.y_label = axis_label("excess position x", Quantity::position, units);
    // an unstable answer would squeeze the other one into a line
    const auto shown = [&](const ForcedResponse& r) {
        LineChart::Line line{"", r.time, r.position};
        for (auto& x : line.y)
            if (std::abs(x) > 3 * motion.peak) x = missing;
        return line;
    };
    auto memory = shown(motion.memory), simple = shown(motion.velocity_only);
    memory.name = "with memory";
    simple.name = "velocity-only model";
    simple.dashed = true;
    chart.lines = {std::move(memory), std::move(simple)};
    return line_figure("forced", std::move(chart),
                       "With memory the link moves by up to " + with_unit(motion.peak, Quantity::position, units) +
                           ", " + with_unit(motion.peak_time, Quantity::time, units) + " after the start.",
                       "d(t) of (9) acts on the link; position in excess of steady sliding by the linear theory, exact "
                       "for a force held over each of " +
                           std::to_string(motion.force.value.size()) + " samples of " +
                           with_unit(motion.force.step, Quantity::time, units) +
                           ". Where a theory calls the joint unstable its line grows until it leaves the picture.");
}

}  // namespace stickslip
