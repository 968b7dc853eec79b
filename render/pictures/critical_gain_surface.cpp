// The critical gain over two parameters, in space.
#include "render/axes/frame.h"
#include "render/drawing/colour_map.h"
#include "render/drawing/markup.h"
#include "render/pictures/picture.h"
#include "render/pictures/scene.h"
#include "render/pictures/surface_rim.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900, fineness = 2;
constexpr double view_left = 84, view_width = 610, room_below = 62, bar_height = 380;
constexpr int x_room = 5, y_room = 5, z_room = 6;  // labels that an edge has room for

constexpr TextStyle tick_style{13}, name_style{14.5};

void check(const CriticalGainSurface& surface)
{
    const std::size_t points = surface.x.values.size() * surface.y.values.size();
    if (surface.z.size() != points)
        throw std::invalid_argument("critical gain surface \"" + surface.title + "\": " + std::to_string(points) +
                                    " grid points, but " + std::to_string(surface.z.size()) + " values");
}

/// From the lowest to the highest value, on to the next round numbers.
Scale height_scale(const std::vector<double>& z)
{
    Scale tight = spanning(z, false);
    tight.log = needs_log_scale(z);
    if (tight.log)
        return {std::pow(10, std::floor(std::log10(tight.low) + 1e-9)),
                std::pow(10, std::ceil(std::log10(tight.high) - 1e-9)), true};
    const Ticks marks = ticks(tight, 6);
    const double step = marks.major.size() > 1 ? marks.major[1].value - marks.major[0].value : tight.high - tight.low;
    return {std::floor(tight.low / step + 1e-9) * step, std::ceil(tight.high / step - 1e-9) * step, false};
}

/// One edge of the box with its ticks: where it runs, and which way is out.
struct Edge {
    ChartAxis axis;
    int room;
    std::function<Point(double along, double out)> at;
    Point label_offset;    ///< from the tick's foot, px
    double name_distance;  ///< px outwards; 0: no name
    Across across;
    Along along;
};

constexpr double tick_length = 7;

double distance_out(const Edge& edge, double along, double pixels)
{
    const Point a = edge.at(along, 0), b = edge.at(along, 0.01);
    return 0.01 * pixels / std::hypot(b.x - a.x, b.y - a.y);
}

void draw_edge(Canvas& canvas, const Edge& edge)
{
    canvas.line({edge.at(0, 0), edge.at(1, 0)}, {theme::ink, 1.2});
    const Ticks marks = ticks(edge.axis.scale, edge.room, edge.axis.label.divisor);
    std::vector<Point> ends;
    const auto mark = [&](double value, double length) {
        const double along = edge.axis.scale.at(value);
        ends.push_back(edge.at(along, 0));
        ends.push_back(edge.at(along, distance_out(edge, along, length)));
    };
    for (const double value : marks.minor) mark(value, 0.55 * tick_length);
    for (const Tick& tick : marks.major) {
        mark(tick.value, tick_length);
        const Point foot = edge.at(edge.axis.scale.at(tick.value), 0);
        canvas.text({foot.x + edge.label_offset.x, foot.y + edge.label_offset.y}, tick.label, tick_style, edge.across,
                    edge.along);
    }
    canvas.stretches(ends, {theme::ink, 1});
    if (edge.name_distance <= 0) return;
    const Point a = edge.at(0, 0), b = edge.at(1, 0);
    TextStyle slanted = name_style;
    slanted.angle = -std::atan2(b.y - a.y, b.x - a.x) * 180 / M_PI;
    canvas.text(edge.at(0.5, distance_out(edge, 0.5, edge.name_distance)), edge.axis.label.text, slanted,
                Across::centre, Along::middle);
}

/// Grid lines on the floor and the two far walls, at the labelled ticks.
void draw_walls(Canvas& canvas, const Scene& scene, const Edge& x, const Edge& y, const Edge& z)
{
    std::vector<Point> ends;
    const auto add = [&](Point a, Point b) { ends.insert(ends.end(), {a, b}); };
    const auto values = [](const Edge& edge) {
        std::vector<double> list{0, 1};
        for (const Tick& t : ticks(edge.axis.scale, edge.room, edge.axis.label.divisor).major)
            list.push_back(edge.axis.scale.at(t.value));
        return list;
    };
    for (const double u : values(x)) {
        add(scene.project(u, 0, 0), scene.project(u, 1, 0));
        add(scene.project(u, 1, 0), scene.project(u, 1, 1));
    }
    for (const double v : values(y)) {
        add(scene.project(0, v, 0), scene.project(1, v, 0));
        add(scene.project(0, v, 0), scene.project(0, v, 1));
    }
    for (const double w : values(z)) {
        add(scene.project(0, 0, w), scene.project(0, 1, w));
        add(scene.project(0, 1, w), scene.project(1, 1, w));
    }
    canvas.stretches(ends, {theme::rule, 1});
}

std::string where_missing(std::size_t holes, std::size_t rim)
{
    if (holes == 0) return "";
    const std::string none = "Where the surface is missing, no critical gain exists";
    if (rim == 0) return none + ".";
    return none + ", or it falls to zero more steeply than the grid resolves (" + std::to_string(rim) +
           (rim == 1 ? " point)." : " points).");
}

Raster bar_colours()
{
    Raster bar{1, 256, 3, {}};
    for (int row = 255; row >= 0; --row) {
        const Colour c = from_hex(viridis_table[static_cast<std::size_t>(row)]);
        bar.pixels.insert(bar.pixels.end(), {c.red, c.green, c.blue});
    }
    return bar;
}

ColourBar colour_bar(const ChartAxis& z, double middle)
{
    ColourBar bar{{picture_width - 104, middle - bar_height / 2, 17, bar_height}, {}, z.label.text};
    const Ticks marks = ticks(z.scale, 8, z.label.divisor);
    for (const Tick& tick : marks.major) bar.marks.push_back({z.scale.at(tick.value), tick.label});
    for (const double value : marks.minor) bar.marks.push_back({z.scale.at(value), ""});
    return bar;
}

}  // namespace

Drawn draw(const CriticalGainSurface& surface, const std::string& description, const Fonts& fonts)
{
    check(surface);
    const auto holes = std::count_if(surface.z.begin(), surface.z.end(), [](double v) { return !std::isfinite(v); });
    if (static_cast<std::size_t>(holes) == surface.z.size())
        return {"", "no critical gain exists anywhere on this grid", 0, 0, {}};
    const auto axis = [&](const Axis& a) {
        const Scale scale = spanning(a.values, a.log);
        return ChartAxis{scale, axis_label(a.name, a.symbol, a.quantity, surface.units, scale)};
    };
    const ChartAxis x = axis(surface.x), y = axis(surface.y);
    const auto drawn = drawn_heights(surface);
    const Scale z_scale = height_scale(drawn);
    const ChartAxis z{z_scale,
                      axis_label(surface.z_name, surface.z_symbol, surface.z_quantity, surface.units, z_scale)};

    Canvas canvas(picture_width, fonts);
    const double top = draw_heading(canvas, 40, picture_width - 80, surface.title, surface.fixed,
                                    where_missing(static_cast<std::size_t>(holes), unresolved_rim(surface).size()));
    HeightField field;
    for (const double v : surface.x.values) field.columns.push_back(x.scale.at(v));
    for (const double v : surface.y.values) field.rows.push_back(y.scale.at(v));
    for (const double v : drawn) field.heights.push_back(std::isfinite(v) ? z.scale.at(v) : NAN);
    const Ticks heights = ticks(z.scale, 8);
    for (const Tick& tick : heights.major) field.levels.push_back(z.scale.at(tick.value));
    for (const Tick& tick : ticks(x.scale, x_room).major) field.columns_marked.push_back(x.scale.at(tick.value));
    for (const Tick& tick : ticks(y.scale, y_room).major) field.rows_marked.push_back(y.scale.at(tick.value));
    const Scene scene(field, view_left, top, view_width);
    const Snapshot snapshot = scene.photograph(fineness);
    if (!snapshot.missing.empty()) return {"", snapshot.missing, 0, 0, {}};

    const Edge x_edge{x,         x_room, [&](double u, double out) { return scene.project(u, -out, 0); },
                      {-5, 13},  46,     Across::centre,
                      Along::top};
    const Edge y_edge{y,
                      y_room,
                      [&](double v, double out) { return scene.project(1 + out, v, 0); },
                      {14, 2},
                      64,
                      Across::left,
                      Along::middle};
    const Edge z_edge{z,
                      z_room,
                      [&](double w, double out) { return scene.project(-out, 0, w); },
                      {-12, 0},
                      58,
                      Across::right,
                      Along::middle};
    draw_walls(canvas, scene, x_edge, y_edge, z_edge);
    canvas.image(scene.window(), snapshot.raster);
    for (const Edge& edge : {x_edge, y_edge, z_edge}) draw_edge(canvas, edge);
    const double middle = top + (scene.window().height + room_below) / 2;
    draw_colour_bar(canvas, colour_bar(z, middle), bar_colours());
    const int height = static_cast<int>(std::ceil(scene.window().bottom() + room_below));
    return {canvas.svg(height, plain_text(surface.title), description), "", picture_width, height, scene.window()};
}

}  // namespace stickslip::drawing
