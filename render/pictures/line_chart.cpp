// Several named curves over one axis, and a second panel of them below.
#include "render/axes/frame.h"
#include "render/drawing/markup.h"
#include "render/pictures/line_marks.h"
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
constexpr double plot_width = 780, plot_height = 340, lower_height = 190;

// Okabe and Ito's colours for all kinds of colour vision (M. Okabe, K. Ito, Color Universal Design, 2008), the
// yellow left out for its contrast on white.
constexpr std::array<std::uint32_t, 6> line_colours{0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9};

void check(const DetailedChart& chart, const std::vector<DetailedChart::Line>& lines)
{
    const auto refuse = [&](const DetailedChart::Line& line, std::size_t others, const char* name) {
        throw std::invalid_argument("line chart \"" + chart.title + "\": line \"" + line.name + "\" has " +
                                    std::to_string(line.x.size()) + " x and " + std::to_string(others) + " " + name +
                                    " values");
    };
    for (const auto& line : lines) {
        if (line.x.size() != line.y.size()) refuse(line, line.y.size(), "y");
        if (!line.along.empty() && line.x.size() != line.along.size()) refuse(line, line.along.size(), "further");
    }
}

Pen pen_of(std::size_t index, const DetailedChart::Line& line)
{
    constexpr double fine = 1.8, broad = 5, pale = 0.45, see_through = 0.65, thinnest = 1.3;
    if (line.look == DetailedChart::Line::Look::rule) return {theme::ink, thinnest, {}};
    const double opacity = line.wide ? pale : line.see_through ? see_through : 1;
    Pen pen{from_hex(line_colours[index % line_colours.size()], opacity), line.wide ? broad : fine, {}};
    if (line.dashed) pen.dash = {7, 4};
    return pen;
}

double length_of(const std::vector<Polyline>& pieces)
{
    double length = 0;
    for (const Polyline& piece : pieces)
        for (std::size_t i = 0; i + 1 < piece.size(); ++i)
            length += std::hypot(piece[i + 1].x - piece[i].x, piece[i + 1].y - piece[i].y);
    return length;
}

/// Marks on a line that winds, like an orbit or an oscillation, or on one made of dashes would hide it.
bool takes_markers(const std::vector<DetailedChart::Line>& lines, std::size_t index,
                   const std::vector<Polyline>& pieces)
{
    const auto& line = lines[index];
    const bool plain = !line.dashed && !line.wide && line.look == DetailedChart::Line::Look::line;
    return lines.size() > 1 && plain && length_of(pieces) < 3 * (plot_width + plot_height);
}

/// A single line needs a legend only where the axis does not name it already.
bool needs_legend(const DetailedChart& chart)
{
    if (chart.lines.size() != 1) return !chart.lines.empty();
    return chart.y_label.name.find(chart.lines[0].name) == std::string::npos;
}

constexpr TextStyle mark_style{12, theme::muted};
constexpr double mark_line = 17;

/// Where a mark's label is centred: above its mark, or as near as the picture's edges let it stand whole.
double label_middle(Canvas& canvas, const std::string& label, double at)
{
    const double room = 6 + canvas.text_width(label, mark_style) / 2;
    return std::clamp(at, room, picture_width - room);
}

/// Labels of vertical marks stand above the frame, on as many levels as they need. Returns the level of each.
std::vector<int> mark_levels(Canvas& canvas, const DetailedChart& chart, const Scale& x)
{
    std::vector<int> levels;
    std::vector<double> right_end;  // of the last label on each level
    for (const auto& [label, value] : chart.x_marks) {
        const double half = canvas.text_width(label, mark_style) / 2;
        const double middle = label_middle(canvas, label, axis_margin + plot_width * x.at(value));
        std::size_t level = 0;
        while (level < right_end.size() && right_end[level] > middle - half - 8) ++level;
        if (level == right_end.size()) right_end.push_back(0);
        right_end[level] = middle + half;
        levels.push_back(static_cast<int>(level));
    }
    return levels;
}

/// The lines of one panel, and what the legend says of each.
std::vector<LegendEntry> draw_lines(Canvas& canvas, const Frame& frame, const std::vector<DetailedChart::Line>& lines)
{
    std::vector<LegendEntry> entries;
    const Scale& y = frame.y.scale;
    const double edge = y.value(2 / frame.box.height);  // the whole pen's width above the frame
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto& line = lines[i];
        Polyline points;
        for (std::size_t k = 0; k < line.x.size(); ++k)
            points.push_back(frame.at(line.x[k], y.log && line.y[k] >= 0 && line.y[k] < edge ? edge : line.y[k]));
        const bool alone = points.size() == 1 || line.look == DetailedChart::Line::Look::points;
        std::vector<Polyline> pieces = alone ? std::vector<Polyline>{} : clip(points, frame.box);
        const std::size_t place = line.place.value_or(i);
        const Pen pen = pen_of(place, line);
        for (Polyline& piece : pieces) canvas.line(piece = thin(piece, 0.1), pen);
        const bool marked = alone || takes_markers(lines, i, pieces);
        if (alone)
            for (const Point& p : points) {
                if (frame.box.holds(p)) draw_mark(canvas, p, place, pen.colour);
            }
        else if (marked)
            for (const Point& p : marked_samples(points, frame.box, i)) draw_mark(canvas, p, place, pen.colour);
        entries.push_back({[&canvas, alone, marked, pen, place](const Rectangle& box) {
                               const double middle = box.top + box.height / 2;
                               if (!alone) canvas.line({{box.left, middle}, {box.right(), middle}}, pen);
                               if (marked) draw_mark(canvas, {box.left + box.width / 2, middle}, place, pen.colour);
                           },
                           line.name});
    }
    return entries;
}

}  // namespace

Drawn draw(const DetailedChart& chart, const std::string& description, const Fonts& fonts)
{
    check(chart, chart.lines);
    check(chart, chart.below);
    const auto [x, y, lower] = scales_of(chart);
    Canvas canvas(picture_width, fonts);
    const double heading = draw_heading(canvas, axis_margin, plot_width, chart.title, chart.fixed, "");
    const std::vector<int> levels = mark_levels(canvas, chart, x);
    const double marks = levels.empty() ? 0 : mark_line * (*std::max_element(levels.begin(), levels.end()) + 1);
    const ChartAxis across{x, axis_label(chart.x_label, x)};
    const Frame frame{
        {axis_margin, heading + marks, plot_width, plot_height}, across, {y, axis_label(chart.y_label, y)}};
    draw_grid(canvas, frame);
    for (std::size_t i = 0; i < chart.x_marks.size(); ++i) {
        const double at = frame.at(chart.x_marks[i].second, y.low).x, top = frame.box.top - mark_line * levels[i];
        canvas.line({{at, top - 2}, {at, frame.box.bottom()}}, {theme::muted, 1, {4, 3}});
        const auto& label = chart.x_marks[i].first;
        canvas.text({label_middle(canvas, label, at), top - 6}, label, mark_style, Across::centre, Along::baseline);
    }
    const auto entries = draw_lines(canvas, frame, chart.lines);
    double bottom = frame.box.bottom() + axis_depth;
    draw_axes(canvas, frame);
    if (needs_legend(chart)) bottom = draw_legend(canvas, entries, frame.box.left, bottom + 12, plot_width);
    std::vector<Rectangle> panels;
    if (!chart.below.empty()) {
        const Frame second{{axis_margin, bottom + 14, plot_width, lower_height},
                           across,
                           {lower, axis_label(chart.below_label, lower)}};
        draw_grid(canvas, second);
        const auto named = draw_lines(canvas, second, chart.below);
        draw_axes(canvas, second);
        bottom = draw_legend(canvas, named, second.box.left, second.box.bottom() + axis_depth + 12, plot_width);
        panels.push_back(second.box);
    }
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(chart.title), description),
            "",
            picture_width,
            height,
            frame.box,
            std::move(panels)};
}

Drawn draw(const LineChart& chart, const std::string& description, const Fonts& fonts)
{
    return draw(detailed(chart), description, fonts);
}

}  // namespace stickslip::drawing
