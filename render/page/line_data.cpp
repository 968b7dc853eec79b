#include "render/page/line_data.h"

#include "analysis/results/text.h"
#include "render/csv/csv.h"
#include "render/drawing/markup.h"
#include "render/page/figure_data.h"
#include "render/page/json.h"
#include "render/page/pack_arrays.h"
#include "render/pictures/line_scales.h"

#include <algorithm>
#include <variant>

namespace stickslip::drawing {
namespace {

/// An axis and the stretch of it that is drawn, for a reader over the chart.
std::string drawn_axis(const AxisName& axis, const Scale& scale)
{
    const std::string unit = axis.unit.empty() ? "1" : axis.unit;
    return JsonObject()
        .text("name", axis.name)
        .text("unit", unit)
        .flag("prefix", scaled_unit(1e3, unit).text != unit)
        .flag("log", scale.log)
        .number("low", scale.low)
        .number("high", scale.high)
        .close();
}

std::string line_data(const std::vector<DetailedChart::Line>& list)
{
    std::vector<std::string> lines;
    for (const auto& line : list) {
        JsonObject json;
        json.text("name", plain_text(line.name)).text("x", pack(line.x)).text("y", pack(line.y));
        if (line.place) json.number("place", static_cast<double>(*line.place));
        if (!line.along.empty()) json.text("along", pack(line.along));
        lines.push_back(json.close());
    }
    return json_array(lines);
}

}  // namespace

std::string chart_data(const DetailedChart& chart, const RenderedFigure& rendered)
{
    JsonObject json;
    if (rendered.plot.width > 0) {
        const auto [x, y, below] = scales_of(chart);
        json.raw("area", area_data(rendered.plot, rendered)).raw("xAxis", drawn_axis(chart.x_label, x));
        json.raw("yAxis", drawn_axis(chart.y_label, y));
        if (!rendered.panels.empty())
            json.raw("belowArea", area_data(rendered.panels.front(), rendered))
                .raw("belowAxis", drawn_axis(chart.below_label, below));
        // whatever it spans: only its name and unit are read
        if (!chart.along_label.name.empty()) json.raw("alongAxis", drawn_axis(chart.along_label, Scale{}));
    }
    if (!chart.below.empty()) json.raw("below", line_data(chart.below));
    if (chart.played) json.flag("played", true).flag("turns", chart.turns);
    return json.text("kind", "lines")
        .text("header", csv_header(chart))
        .text("xLabel", plain_text(chart.x_label.text()))
        .text("yLabel", plain_text(chart.y_label.text()))
        .flag("inTime", chart.x_label.unit == unit_of(Quantity::time, Units(Motion::prismatic)))
        .flag("xLog", chart.x_log)
        .flag("yLog", chart.y_log)
        .flag("zoom", zoomable(chart))
        .raw("lines", line_data(chart.lines))
        .close();
}

bool zoomable(const Picture& picture)
{
    constexpr std::size_t long_series = 500;
    const auto* plain = std::get_if<LineChart>(&picture);
    const auto* more = std::get_if<DetailedChart>(&picture);
    if (!plain && !more) return false;
    const DetailedChart chart = plain ? detailed(*plain) : *more;
    if (chart.x_log) return false;
    std::size_t points = 0;
    for (const auto& line : chart.lines) {
        if (!std::is_sorted(line.x.begin(), line.x.end())) return false;
        points += line.x.size();
    }
    return points >= long_series;
}

}  // namespace stickslip::drawing
