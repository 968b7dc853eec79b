#include "render/pictures/line_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::drawing {
namespace {

using Lines = std::vector<DetailedChart::Line>;

std::vector<double> all_values(const Lines& lines, std::vector<double> DetailedChart::Line::*member, bool log)
{
    std::vector<double> values;
    for (const auto& line : lines)
        for (const double v : line.*member)
            if (!log || v > 0) values.push_back(v);
    return values;
}

/// A little air above and below, so that a flat line does not lie on the frame.
Scale with_room(Scale scale)
{
    constexpr double room = 0.04;
    return {scale.value(-room), scale.value(1 + room), scale.log};
}

/// On a log axis a line that meets zero would fall without end: a span below the largest value are shown.
Scale above_zero(Scale y, const DetailedChart& chart)
{
    constexpr double span = 1e6;
    const auto meets_zero = [](const DetailedChart::Line& line) {
        return std::find(line.y.begin(), line.y.end(), 0.0) != line.y.end();
    };
    if (y.log && std::any_of(chart.lines.begin(), chart.lines.end(), meets_zero))
        y.low = std::max(y.low, y.high / span);
    return y;
}

/// A curve in the plane, not a function of x, or a single sample: it needs air on all sides.
bool needs_air(const DetailedChart::Line& line)
{
    return line.x.size() == 1 || !std::is_sorted(line.x.begin(), line.x.end());
}

/// The values between which a line spends the given share of its samples.
std::vector<double> usual_values(const DetailedChart::Line& line, double share)
{
    std::vector<double> sorted;
    for (const double v : line.y)
        if (std::isfinite(v)) sorted.push_back(v);
    if (sorted.empty()) return {};
    std::sort(sorted.begin(), sorted.end());
    const auto rare = static_cast<std::size_t>((1 - share) / 2 * static_cast<double>(sorted.size()));
    return {sorted[rare], sorted[sorted.size() - 1 - rare]};
}

/// Cut to what the lines usually are where a rare spike would flatten them: by more than a half of the axis.
Scale without_spikes(const Scale& whole, const Lines& lines, double share)
{
    if (share >= 1 || whole.log) return whole;
    constexpr double worth = 2, air = 0.25;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& line : lines)
        for (const double v : usual_values(line, share)) low = std::min(low, v), high = std::max(high, v);
    const double span = high - low;
    if (!(span > 0) || whole.high - whole.low < worth * span) return whole;
    return {std::max(whole.low, low - air * span), std::min(whole.high, high + air * span), false};
}

}  // namespace

LineScales scales_of(const DetailedChart& chart)
{
    std::vector<double> xs = all_values(chart.lines, &DetailedChart::Line::x, chart.x_log);
    for (const auto& mark : chart.x_marks) xs.push_back(mark.second);
    const bool air = std::any_of(chart.lines.begin(), chart.lines.end(), needs_air);
    const Scale x = spanning(xs, chart.x_log);
    const Scale y = spanning(all_values(chart.lines, &DetailedChart::Line::y, chart.y_log), chart.y_log);
    LineScales scales{air ? with_room(x) : x,
                      with_room(without_spikes(above_zero(y, chart), chart.lines, chart.shown_share))};
    if (!chart.below.empty())
        scales.below = with_room(without_spikes(
            spanning(all_values(chart.below, &DetailedChart::Line::y, false), false), chart.below, chart.shown_share));
    return scales;
}

LineScales scales_of(const LineChart& chart)
{
    return scales_of(detailed(chart));
}

}  // namespace stickslip::drawing
