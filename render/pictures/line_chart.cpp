// Several named curves over one axis.
#include "render/axes/frame.h"
#include "render/drawing/markup.h"
#include "render/pictures/line_scales.h"
#include "render/pictures/picture.h"
#include "render/pictures/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900;
constexpr double plot_width = 780, plot_height = 340;

// Okabe and Ito's colours for all kinds of colour vision (M. Okabe, K. Ito, Color Universal Design, 2008), the
// yellow left out for its contrast on white.
constexpr std::array<std::uint32_t, 6> line_colours{0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9};

void check(const LineChart& chart)
{
    for (const auto& line : chart.lines)
        if (line.x.size() != line.y.size())
            throw std::invalid_argument("line chart \"" + chart.title + "\": line \"" + line.name + "\" has " +
                                        std::to_string(line.x.size()) + " x and " + std::to_string(line.y.size()) +
                                        " y values");
}

Pen pen_of(std::size_t index, bool dashed)
{
    Pen pen{from_hex(line_colours[index % line_colours.size()]), 1.8, {}};
    if (dashed) pen.dash = {7, 4};
    return pen;
}

/// One of four shapes, so that lines are told apart without colour.
void marker(Canvas& canvas, Point at, std::size_t index, Colour colour)
{
    constexpr double r = 4;
    switch (index % 4) {
        case 0:
            return canvas.circle(at, r, colour);
        case 1:
            return canvas.rectangle({at.x - r * 0.9, at.y - r * 0.9, r * 1.8, r * 1.8}, colour);
        case 2:
            return canvas.area({{at.x, at.y - r * 1.2}, {at.x + r * 1.15, at.y + r}, {at.x - r * 1.15, at.y + r}},
                               colour);
        default:
            return canvas.area(
                {{at.x, at.y - r * 1.3}, {at.x + r * 1.3, at.y}, {at.x, at.y + r * 1.3}, {at.x - r * 1.3, at.y}},
                colour);
    }
}

double length_of(const std::vector<Polyline>& pieces)
{
    double length = 0;
    for (const Polyline& piece : pieces)
        for (std::size_t i = 0; i + 1 < piece.size(); ++i)
            length += std::hypot(piece[i + 1].x - piece[i].x, piece[i + 1].y - piece[i].y);
    return length;
}

/// Marks on a line that winds, like an orbit or an oscillation, or on one made of dashes would read as samples.
bool takes_markers(const LineChart& chart, std::size_t index, const std::vector<Polyline>& pieces)
{
    return chart.lines.size() > 1 && !chart.lines[index].dashed && length_of(pieces) < 3 * (plot_width + plot_height);
}

/// A single line needs a legend only where the axis does not name it already.
bool needs_legend(const LineChart& chart)
{
    if (chart.lines.size() != 1) return !chart.lines.empty();
    return chart.y_label.find(chart.lines[0].name) == std::string::npos;
}

/// Evenly spaced along the visible line, each line with its own offset.
void draw_markers(Canvas& canvas, const std::vector<Polyline>& pieces, std::size_t index)
{
    constexpr double apart = 130;
    double until_next = 30 + 27.0 * static_cast<double>(index % 4);
    for (const Polyline& piece : pieces)
        for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
            const Point a = piece[i], b = piece[i + 1];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            for (; until_next < length; until_next += apart) {
                const double t = until_next / length;
                marker(canvas, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, index,
                       from_hex(line_colours[index % line_colours.size()]));
            }
            until_next -= length;
        }
}

constexpr TextStyle mark_style{12, theme::muted};
constexpr double mark_line = 17;

/// Labels of vertical marks stand above the frame, on as many levels as they need. Returns the level of each.
std::vector<int> mark_levels(Canvas& canvas, const LineChart& chart, const Scale& x)
{
    std::vector<int> levels;
    std::vector<double> right_end;  // of the last label on each level
    for (const auto& [label, value] : chart.x_marks) {
        const double middle = axis_margin + plot_width * x.at(value), half = canvas.text_width(label, mark_style) / 2;
        std::size_t level = 0;
        while (level < right_end.size() && right_end[level] > middle - half - 8) ++level;
        if (level == right_end.size()) right_end.push_back(0);
        right_end[level] = middle + half;
        levels.push_back(static_cast<int>(level));
    }
    return levels;
}

}  // namespace

Drawn draw(const LineChart& chart, const std::string& description, const Fonts& fonts)
{
    check(chart);
    const auto [x, y] = scales_of(chart);
    Canvas canvas(picture_width, fonts);
    const double heading = draw_heading(canvas, axis_margin, plot_width, chart.title, chart.fixed, "");
    const std::vector<int> levels = mark_levels(canvas, chart, x);
    const double marks = levels.empty() ? 0 : mark_line * (*std::max_element(levels.begin(), levels.end()) + 1);
    const Frame frame{{axis_margin, heading + marks, plot_width, plot_height},
                      {x, axis_label(chart.x_label, x)},
                      {y, axis_label(chart.y_label, y)}};
    draw_grid(canvas, frame);
    for (std::size_t i = 0; i < chart.x_marks.size(); ++i) {
        const double at = frame.at(chart.x_marks[i].second, y.low).x, top = frame.box.top - mark_line * levels[i];
        canvas.line({{at, top - 2}, {at, frame.box.bottom()}}, {theme::muted, 1, {4, 3}});
        canvas.text({at, top - 6}, chart.x_marks[i].first, mark_style, Across::centre, Along::baseline);
    }
    std::vector<LegendEntry> entries;
    const double edge = y.value(2 / plot_height);  // the whole pen's width above the frame
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        const auto& line = chart.lines[i];
        Polyline points;
        for (std::size_t k = 0; k < line.x.size(); ++k)
            points.push_back(frame.at(line.x[k], y.log && line.y[k] >= 0 && line.y[k] < edge ? edge : line.y[k]));
        std::vector<Polyline> pieces = clip(points, frame.box);
        const Pen pen = pen_of(i, line.dashed);
        for (Polyline& piece : pieces) canvas.line(piece = thin(piece, 0.1), pen);
        const bool alone = points.size() == 1, marked = alone || takes_markers(chart, i, pieces);
        if (alone)
            marker(canvas, points.front(), i, pen.colour);
        else if (marked)
            draw_markers(canvas, pieces, i);
        entries.push_back({[&canvas, alone, marked, pen, i](const Rectangle& box) {
                               const double middle = box.top + box.height / 2;
                               if (!alone) canvas.line({{box.left, middle}, {box.right(), middle}}, pen);
                               if (marked) marker(canvas, {box.left + box.width / 2, middle}, i, pen.colour);
                           },
                           line.name});
    }
    draw_axes(canvas, frame);
    double bottom = frame.box.bottom() + axis_depth;
    if (needs_legend(chart)) bottom = draw_legend(canvas, entries, frame.box.left, bottom + 12, plot_width);
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(chart.title), description), "", picture_width, height, frame.box};
}

}  // namespace stickslip::drawing
