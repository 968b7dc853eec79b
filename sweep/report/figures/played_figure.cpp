// A record that the page can play: the joint as it moved and as the simulations move it.
#include "sweep/report/figures/diagnosis_figures.h"

#include "sweep/report/figures/trace_lines.h"

#include <algorithm>

namespace stickslip {
namespace {

/// Every n-th sample, so that a page of a long record stays small.
std::vector<double> thinned(const std::vector<double>& values, std::size_t stride)
{
    std::vector<double> some;
    for (std::size_t k = 0; k < values.size(); k += stride) some.push_back(values[k]);
    return some;
}

}  // namespace

std::vector<Figure> played_figures(const Diagnosis& d)
{
    if (d.traces.empty()) return {};
    const auto& trace = d.traces.front();
    const std::size_t n = std::min({trace.time.size(), trace.measured.size(), trace.before.size()});
    if (n < 2 || rms_of(difference(trace.measured, trace.before)) == 0) return {};
    constexpr std::size_t most = 1500;
    const std::size_t stride = (n + most - 1) / most;
    const bool named = d.verdict == Verdict::gap, efforts = !trace.effort_measured.empty();
    const auto time = thinned(trace.time, stride);
    DetailedChart chart;
    chart.title = "The record, measured and " + made(trace) + ": " + trace.file;
    chart.x_label = {"time", "s"};
    chart.y_label = {"position", std::string(unit_of(Quantity::position, Units(d.motion)))};
    chart.played = true;
    chart.turns = d.motion == Motion::revolute;
    const auto three = [&](const std::vector<double>& measured, const std::vector<double>& before,
                           const std::vector<double>& after) {
        std::vector<DetailedChart::Line> lines{
            measured_line(time, thinned(measured, stride)),
            {made(trace) + (named ? " before" : ""), time, thinned(before, stride), true}};
        if (named) lines.push_back({made(trace) + " after", time, thinned(after, stride), false});
        return lines;
    };
    chart.lines = three(trace.measured, trace.before, trace.after);
    if (efforts) {
        chart.below_label = {effort_name(trace.effort), trace.effort_unit};
        chart.below = three(trace.effort_measured, trace.effort_before, trace.effort_after);
        chart.shown_share = usual_share;
    }
    std::string words = "Position" + std::string(efforts ? " and effort" : "") + " over the whole record";
    if (stride > 1) words += ", one sample in " + std::to_string(stride);
    return {{"record-played", chart,
             words + ". On a screen the record can be played: the joint as it moved and as the " +
                 (trace.predicted ? "predictions" : "simulations") + " move it, their errors magnified.",
             words + ", measured and " + made(trace)}};
}

}  // namespace stickslip
