#include "render/pictures/line_scales.h"

#include <algorithm>

namespace stickslip::drawing {
namespace {

std::vector<double> all_values(const LineChart& chart, std::vector<double> LineChart::Line::*member, bool log)
{
    std::vector<double> values;
    for (const auto& line : chart.lines)
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
Scale above_zero(Scale y, const LineChart& chart)
{
    constexpr double span = 1e6;
    const auto meets_zero = [](const LineChart::Line& line) {
        return std::find(line.y.begin(), line.y.end(), 0.0) != line.y.end();
    };
    if (y.log && std::any_of(chart.lines.begin(), chart.lines.end(), meets_zero))
        y.low = std::max(y.low, y.high / span);
    return y;
}

/// A curve in the plane, not a function of x, or a single sample: it needs air on all sides.
bool needs_air(const LineChart::Line& line)
{
    return line.x.size() == 1 || !std::is_sorted(line.x.begin(), line.x.end());
}

}  // namespace

LineScales scales_of(const LineChart& chart)
{
    std::vector<double> xs = all_values(chart, &LineChart::Line::x, chart.x_log);
    for (const auto& mark : chart.x_marks) xs.push_back(mark.second);
    const bool air = std::any_of(chart.lines.begin(), chart.lines.end(), needs_air);
    const Scale x = spanning(xs, chart.x_log);
    const Scale y = spanning(all_values(chart, &LineChart::Line::y, chart.y_log), chart.y_log);
    return {air ? with_room(x) : x, with_room(above_zero(y, chart))};
}

}  // namespace stickslip::drawing
