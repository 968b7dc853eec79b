#include "sweep/report/pages/comparison_section.h"

#include "sweep/report/figures/line_figure.h"
#include "sweep/report/pages/gain_words.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

std::string degrees(double angle)
{
    return std::isnan(angle) ? "–" : plain_number(angle * 180 / std::numbers::pi, 3) + "°";
}

}  // namespace

Section response_section(const Joint& joint, const LinearDetails& details)
{
    const auto& study = details.study;
    const GainWords words{units_of(joint)};
    const auto compliance = [&](double x_per_d) {
        const bool none = std::isnan(x_per_d);
        return none ? std::string("–") : with_unit(1 / x_per_d, Quantity::stiffness, words.units, 4);
    };
    Section section{"response", "Disturbances and margins", "", {}, {}};

    LineChart chart;
    chart.title = "Displacement per disturbing force";
    chart.x_label = axis_label("frequency ω", Quantity::angular_frequency, words.units);
    chart.y_label = words.units.motion == Motion::prismatic ? AxisName{"|X/D|", "m/N"} : AxisName{"|X/D|", "rad/(N·m)"};
    chart.x_log = chart.y_log = true;
    chart.lines = {{"with memory", details.response_memory.x, details.response_memory.y},
                   {"velocity-only model", details.response_simple.x, details.response_simple.y, true}};
    const bool stable = !std::isnan(study.peak.magnitude);
    if (stable && study.peak.omega > 0)
        chart.x_marks.emplace_back("peak at " + with_unit(study.peak.omega, Quantity::angular_frequency, words.units),
                                   study.peak.omega);
    const std::string finding =
        stable ? "The joint yields most at " + words.frequency(study.peak.omega) +
                     ": a sine of force there meets a stiffness of " + compliance(study.peak.magnitude) +
                     " only, against " + compliance(study.compliance) + " for a lasting force."
               : "Sliding is unstable here: the curve is the response of the linear joint, which has no steady sine.";
    section.figures.push_back(line_figure("response-curve", std::move(chart), finding,
                                          "Equation (19): displacement of the link per disturbing force on it, about "
                                          "steady sliding. An impulse, a step or "
                                          "noise d(t) is answered by the same function."));
    if (!stable) return section;
    const auto& m = study.margins;
    Table table;
    table.title = "Margins of the loop";
    table.columns = {"quantity", "value"};
    table.rows = {
        {"k_{p} alone may fall", m.gain_below > 0 ? "to " + plain_number(m.gain_below, 4) + " × its value" : "to 0"},
        {"k_{p} alone may grow",
         std::isfinite(m.gain_above) ? "to " + plain_number(m.gain_above, 4) + " × its value" : "without limit"},
        {"phase margin", degrees(m.phase)},
        {"at the crossover frequency", words.frequency(m.crossover)}};
    section.tables.push_back(std::move(table));
    return section;
}

}  // namespace stickslip
