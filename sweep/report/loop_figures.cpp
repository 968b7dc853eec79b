#include "sweep/report/loop_figures.h"

#include "analysis/results/text.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/loop.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/study.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int locus_gains = 400, velocity_gains = 81, velocity_scan = 80;

std::vector<double> log_steps(double low, double high, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
    return values;
}

std::string stiffness(double k, Motion motion)
{
    return with_unit(k, Quantity::stiffness, motion);
}

/// Where a root lies that decides stability: those far to the left would squeeze the rest into a line.
double reach(const std::vector<std::vector<std::complex<double>>>& rows)
{
    double size = 0;
    for (const auto& row : rows) {
        const auto slowest =
            *std::max_element(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.real() < b.real(); });
        size = std::max(size, std::abs(slowest));
    }
    return size;
}

Figure root_locus_figure(const Joint& joint, const LinearJoint& linear, double low, double high)
{
    const auto motion = joint.mechanism.motion;
    const auto gains = log_steps(low, high, locus_gains);
    const auto rows = root_locus(linear, gains);
    const double limit = 1.2 * reach(rows);
    LineChart chart;
    chart.title = "Root locus over k_{p}";
    chart.fixed = "k_{p} from " + stiffness(low, motion) + " to " + stiffness(high, motion) + ", roots with |s| < " +
                  with_unit(limit, Quantity::rate, motion);
    chart.x_label = "Re s [1/s]";
    chart.y_label = "Im s [rad/s]";
    for (std::size_t branch = 0; branch < rows.front().size(); ++branch) {
        LineChart::Line line;
        line.name = "root " + std::to_string(branch + 1);
        for (const auto& row : rows) {
            const bool near = std::abs(row[branch]) <= limit;
            line.x.push_back(near ? row[branch].real() : missing);
            line.y.push_back(near ? row[branch].imag() : missing);
        }
        if (std::any_of(line.x.begin(), line.x.end(), [](double v) { return std::isfinite(v); }))
            chart.lines.push_back(std::move(line));
    }
    chart.x_marks.emplace_back("boundary Re s = 0", 0);
    const auto slowest = [&](const auto& row) {
        double real = -infinity;
        for (const auto& s : row) real = std::max(real, s.real());
        return real;
    };
    std::string crossing;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if ((slowest(rows[i - 1]) < 0) != (slowest(rows[i]) < 0))
            crossing += (crossing.empty() ? "" : ", ") + stiffness(std::sqrt(gains[i - 1] * gains[i]), motion);
    Figure figure;
    figure.id = "root-locus";
    figure.finding =
        "Root locus over the position gain. " + (crossing.empty() ? std::string("No root crosses the imaginary axis.")
                                                                  : "Stability changes near k_{p} = " + crossing + ".");
    figure.caption =
        "How to read it: each line follows one root of the design's characteristic equation while k_{p} "
        "alone changes; left of the dashed mark it decays. " +
        figure.finding;
    figure.picture = std::move(chart);
    return figure;
}

Figure least_velocity_figure(const Joint& joint, double low, double high)
{
    const auto motion = joint.mechanism.motion;
    const auto gains = log_steps(low, high, velocity_gains);
    const double scale = std::pow(10, study_decades), slowest = joint.control.V0 / scale,
                 fastest = joint.control.V0 * scale;
    LineChart chart;
    chart.title = "Least velocity from which on all sliding is smooth";
    chart.fixed = "searched from " + with_unit(slowest, Quantity::velocity, motion) + " to " +
                  with_unit(fastest, Quantity::velocity, motion);
    chart.x_label = "position gain k_{p} [" + std::string(unit_of(Quantity::stiffness, motion)) + "]";
    chart.y_label = "V_{min} [" + std::string(unit_of(Quantity::velocity, motion)) + "]";
    chart.x_log = chart.y_log = true;
    std::string ends;
    for (const auto theory : {Theory::state_variable, Theory::velocity_only}) {
        const bool memory = theory == Theory::state_variable;
        LineChart::Line line{memory ? "with memory" : "velocity-only theory", gains,
                             std::vector<double>(gains.size(), missing), !memory};
        tbb::parallel_for(std::size_t{0}, gains.size(), [&](std::size_t i) {
            Joint at = joint;
            at.control.k_p = gains[i];
            line.y[i] = stable_velocities(at, slowest, fastest, theory, velocity_scan).all_above;
        });
        if (memory && std::isfinite(line.y.front()) && std::isfinite(line.y.back()))
            ends = "from " + with_unit(line.y.front(), Quantity::velocity, motion) + " at " + stiffness(low, motion) +
                   " to " + with_unit(line.y.back(), Quantity::velocity, motion) + " at " + stiffness(high, motion);
        if (std::any_of(line.y.begin(), line.y.end(), [](double v) { return std::isfinite(v); }))
            chart.lines.push_back(std::move(line));
    }
    Figure figure;
    if (chart.lines.empty()) return figure;
    chart.x_marks.emplace_back("design", joint.control.k_p);
    figure.id = "least-velocity";
    figure.finding = "Least velocity above which all sliding is smooth, over the position gain" +
                     (ends.empty() ? std::string(".") : ": with memory " + ends + ".");
    figure.caption =
        "How to read it: above a line every velocity up to the end of the search slides smoothly. Compared "
        "are friction with memory (solid) and friction that depends on velocity alone (dashed). " +
        figure.finding + " Smooth velocities below a strip of stick-slip are not shown here.";
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace

std::vector<Figure> loop_figures(const Joint& joint, double low, double high)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none || !(steady.velocity > 0) || !(low > 0)) return {};
    const LinearJoint linear = linear_joint(joint, steady.velocity);
    if (!linear.rational()) return {};
    std::vector<Figure> figures{root_locus_figure(joint, linear, low, high)};
    if (joint.control.V0 > 0)
        if (auto figure = least_velocity_figure(joint, low, high); !figure.id.empty())
            figures.push_back(std::move(figure));
    return figures;
}

}  // namespace stickslip
