#include "sweep/report/figures/profile_figures.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/rests.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/nonlinear_findings.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

struct OutcomeKind {
    const char *column, *id, *title, *meaning;
};

constexpr OutcomeKind outcome_kinds[] = {
    {"amplitude", "amplitude", "Amplitude of the limit cycle", "Half the peak-to-peak position."},
    {"period", "period", "Period of the limit cycle", "Duration of one limit cycle."},
    {"stick_fraction", "rest", "Share of the period spent sticking",
     "Share of each cycle at rest or below a hundredth of V_{0}."}};

void mark_design(const Joint& joint, const Axis& axis, LineChart& chart)
{
    const double own = *find_parameter(joint, axis.path);
    if (own >= axis.values.front() && own <= axis.values.back()) chart.x_marks.emplace_back("design", own);
}

}  // namespace

Figure profile_figure(const Joint& joint, const Profile& profile, const ProfileAnswer& answer)
{
    const Units units = units_of(joint);
    const auto& axis = profile.axis;
    LineChart chart;
    chart.title = "Decay and growth over " + axis.symbol;
    chart.x_label = {axis.name + " " + axis.symbol, std::string(unit_of(axis.quantity, units))};
    chart.y_label = {"max Re s", "1/s"};
    chart.x_log = axis.log;
    chart.lines.push_back({"with memory", axis.values, profile.abscissa});
    chart.lines.push_back({"velocity-only model", axis.values, answer.velocity_only_abscissa, true});
    mark_design(joint, axis, chart);
    std::string crossings, simple;
    for (const auto& point : answer.memory) {
        chart.x_marks.emplace_back(with_unit(point.value, axis.quantity, units, 4), point.value);
        crossings += (crossings.empty() ? "" : ", ") + with_unit(point.value, axis.quantity, units, 6);
    }
    for (const auto& point : answer.velocity_only)
        simple += (simple.empty() ? "" : ", ") + with_unit(point.value, axis.quantity, units, 6);
    Figure figure;
    figure.id = chart_id("profile", axis, axis);
    figure.finding =
        (crossings.empty() ? "With memory no change of stability along " + axis.name
                           : "With memory stability changes at " + crossings) +
        (simple.empty() ? ", in the velocity-only model nowhere" : ", in the velocity-only model at " + simple);
    figure.caption = "Largest real part of the spectrum along " + axis.symbol +
                     " with memory and in the velocity-only model; below zero small disturbances "
                     "decay. " +
                     figure.finding + "." +
                     (profile.held.empty() ? "" : " Held: " + held_text(profile.held, units) + ".");
    figure.picture = std::move(chart);
    return figure;
}

std::vector<Figure> outcome_profiles(const Joint& joint, const Profile& profile)
{
    const Units units = units_of(joint);
    const auto& axis = profile.axis;
    std::vector<Figure> figures;
    for (const auto& kind : outcome_kinds)
        for (const auto& reading : profile.readings) {
            const auto values = cycle_values(reading, rests_of(profile.readings));
            const auto cycles = std::count_if(values.begin(), values.end(), [](double v) { return !std::isnan(v); });
            if (reading.column != kind.column || cycles == 0) continue;
            LineChart chart;
            chart.title = std::string(kind.title) + " over " + axis.symbol;
            chart.x_label = axis_label(axis.name + " " + axis.symbol, axis.quantity, units);
            chart.y_label = reading.quantity == Quantity::number ? AxisName{reading.name}
                                                                 : axis_label(reading.name, reading.quantity, units);
            chart.x_log = axis.log;
            chart.lines.push_back({reading.name, axis.values, values});
            mark_design(joint, axis, chart);
            double low = infinity, high = -infinity;
            for (const double v : values)
                if (!std::isnan(v)) low = std::min(low, v), high = std::max(high, v);
            if (high == 0) continue;  // cycles that never rest: nothing to see
            const auto finding =
                std::string(kind.title) + ": " + span_text(low, high, reading.quantity, units, from_to) + " on " +
                std::to_string(cycles) + " of " + std::to_string(values.size()) + " points; none elsewhere.";
            figures.push_back(line_figure(chart_id(kind.id, axis, axis), std::move(chart), finding,
                                          std::string(kind.meaning) + " " + followed_text(profile.readings) +
                                              "; where the line ends, " + none_reached(rests_of(profile.readings)) +
                                              "."));
        }
    return figures;
}

}  // namespace stickslip
