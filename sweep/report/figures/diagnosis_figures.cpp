// What a simulation gets wrong of a record: its residuals, and the stretch where they are worst.
#include "sweep/report/figures/diagnosis_figures.h"

#include "sweep/report/figures/trace_lines.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int most_records = 3;

/// One signal of one record: measured, and simulated before and after.
struct Signal {
    const DiagnosedTrace& trace;
    std::string name, quantity, unit, id;  ///< "measured effort", "effort"
    const std::vector<double>&measured, &before, &after;
    bool named;  ///< a cause is added; else both simulations are the same
};

/// The stretch of a trace in which the simulation before the cause errs most: over the whole of a record the lines lie
/// on each other.
std::pair<std::size_t, std::size_t> worst_stretch(const Signal& s)
{
    const std::vector<double>& time = s.trace.time;
    constexpr double seconds = 1.5;
    const std::size_t n = std::min({time.size(), s.measured.size(), s.before.size()});
    if (n < 2 || time[n - 1] - time[0] <= 2 * seconds) return {0, n};
    const auto rows =
        std::max<std::size_t>(2, static_cast<std::size_t>(seconds / (time[n - 1] - time[0]) * static_cast<double>(n)));
    double sum = 0, largest = -1;
    std::size_t best = 0;
    const auto square = [&](std::size_t k) {
        const double e = s.measured[k] - s.before[k];
        return std::isfinite(e) ? e * e : 0;
    };
    for (std::size_t k = 0; k < n; ++k) {
        sum += square(k);
        if (k >= rows) sum -= square(k - rows);
        if (k + 1 >= rows && sum > largest) largest = sum, best = k + 1 - rows;
    }
    return {best, best + rows};
}

std::vector<double> cut(const std::vector<double>& values, std::pair<std::size_t, std::size_t> stretch)
{
    const auto end = std::min(stretch.second, values.size());
    return {values.begin() + static_cast<std::ptrdiff_t>(std::min(stretch.first, end)),
            values.begin() + static_cast<std::ptrdiff_t>(end)};
}

// a simulation and what it leaves have one pen on all charts of a page
constexpr std::size_t place_before = 1, place_after = 2;

DetailedChart::Line before_line(const char* name, std::vector<double> time, std::vector<double> values)
{
    DetailedChart::Line line{name, std::move(time), std::move(values), true};
    line.place = place_before;
    line.see_through = true;
    return line;
}

DetailedChart::Line remaining_line(std::vector<double> time, std::vector<double> values)
{
    DetailedChart::Line line{"after", std::move(time), std::move(values), false};
    line.place = place_after;
    return line;
}

constexpr const char* along_the_reference =
    "The simulation follows the reference; it does not use the measured motion.";
constexpr const char* along_the_motion =
    "Without the reference that the machine followed no loop can be simulated: the joint is driven by what drove the "
    "machine and kept near the measured motion by a slow observer (12 rad/s), so that its error is that of about a "
    "tenth of a second.";

Figure overlay(const Signal& s)
{
    const auto stretch = worst_stretch(s);
    const auto time = cut(s.trace.time, stretch);
    const auto wrong = [&](const std::vector<double>& simulated) {
        return cut(difference(s.measured, simulated), stretch);
    };
    DetailedChart chart;
    chart.title = "Measured and " + made(s.trace) + " " + s.quantity + " where it is worst: " + s.trace.file;
    chart.x_label = {"time", "s"};
    chart.y_label = {s.name, s.unit};
    chart.below_label = {"measured minus " + made(s.trace), s.unit};
    chart.shown_share = usual_share;
    chart.lines = {measured_line(time, cut(s.measured, stretch)),
                   {made(s.trace) + (s.named ? " before" : ""), time, cut(s.before, stretch), true}};
    chart.below = {before_line(s.named ? "before" : "residual", time, wrong(s.before))};
    if (s.named) {
        chart.lines.push_back({made(s.trace) + " after", time, cut(s.after, stretch), false});
        chart.below.push_back(remaining_line(time, wrong(s.after)));
    }
    return {s.id, chart,
            std::string("The interval of the documented joint's largest error; below, the residual. ") +
                (s.trace.predicted ? along_the_motion : along_the_reference),
            "Measured " + s.name + " over time and " +
                (s.named ? "two " + made(s.trace) + " ones, before and after the cause is added"
                         : "the " + made(s.trace) + " one") +
                ", and their residuals below"};
}

Figure residual(const Signal& s)
{
    const auto before = difference(s.measured, s.before), after = difference(s.measured, s.after);
    DetailedChart chart;
    chart.title = std::string(s.trace.predicted ? "Error of the prediction in " : "Error of the simulation in ") +
                  s.name + ": " + s.trace.file;
    chart.x_label = {"time", "s"};
    chart.y_label = {"measured minus " + made(s.trace), s.unit};
    chart.shown_share = usual_share;
    constexpr const char* spikes = " Rare spikes may be cut at the frame; the data contain them.";
    if (!s.named) {
        chart.lines = {{"measured minus " + made(s.trace), s.trace.time, before, false}};
        const std::string words = "Residual of " + s.name + " over time.";
        return {s.id + "-residual", chart, words + spikes, words};
    }
    chart.lines = {before_line("before", s.trace.time, before), remaining_line(s.trace.time, after)};
    const double was = rms_of(before), is = rms_of(after);
    std::string words = "Residual of " + s.name + " over time, before and after";
    if (was > 0) words += ": its RMS goes to " + std::to_string(std::lround(100 * is / was)) + " % of its former value";
    return {s.id + "-residual", chart, words + "." + spikes, words};
}

}  // namespace

std::vector<Figure> trace_figures(const Diagnosis& d)
{
    const std::string position(unit_of(Quantity::position, Units(d.motion)));
    std::vector<Figure> figures;
    int n = 0;
    for (const auto& trace : d.traces) {
        if (++n > most_records) break;
        const std::string id = "record-" + std::to_string(n);
        const bool named = d.verdict == Verdict::gap;
        const Signal motion{trace,          "position",   "position",  position, id + "-position",
                            trace.measured, trace.before, trace.after, named};
        const Signal effort{trace,
                            effort_name(trace.effort),
                            trace.effort == DiagnosedTrace::Effort::measured ? "effort" : effort_name(trace.effort),
                            trace.effort_unit,
                            id + "-effort",
                            trace.effort_measured,
                            trace.effort_before,
                            trace.effort_after,
                            named};
        const bool forces = !trace.effort_measured.empty();
        // a rig's load point moves as commanded: there is nothing to get wrong
        const bool moves = rms_of(difference(trace.measured, trace.before)) > 0;
        if (moves) figures.push_back(residual(motion));
        if (forces) figures.push_back(residual(effort));
        if (n > 1) continue;
        if (moves) figures.push_back(overlay(motion));
        if (forces) figures.push_back(overlay(effort));
    }
    return figures;
}

Figure experiment_figure(const Diagnosis& d)
{
    DetailedChart motion;
    motion.title = "Next experiment";
    motion.x_label = {"time", "s"};
    motion.y_label = {"reference", std::string(unit_of(Quantity::position, Units(d.motion)))};
    motion.lines = {{"reference", d.next_experiment.time, d.next_experiment.reference, false}};
    return {"next-experiment", motion, "The reference is beside the page as next-experiment.csv.",
            "Reference of the next experiment over time"};
}

}  // namespace stickslip
