// A number or a class over two axes: amplitudes, periods, what changed from one run to another.
#include "render/axes/frame.h"
#include "render/drawing/markup.h"
#include "render/pictures/curve_style.h"
#include "render/pictures/design_mark.h"
#include "render/pictures/picture.h"
#include "render/pictures/region_raster.h"
#include "render/pictures/regions.h"
#include "render/pictures/signed_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900;
constexpr double plot_width = 640, plot_height = 430, bar_gap = 24, bar_width = 17;

// Light tints of Okabe and Ito's colours, distinguished by their textures as well.
constexpr std::array<std::uint32_t, 6> class_colours{0xdde8f0, 0xd9cfc6, 0x6fbfe8, 0xe08a4a, 0xd9a3c0, 0xb8bcc2};
// The texture of each class, the last one being that of places that nobody decided.
constexpr std::array<Region, 6> class_textures{Region::stable,        Region::unstable, Region::memory_only,
                                               Region::velocity_only, Region::bistable, Region::undecided};
constexpr std::array<std::uint32_t, 4> line_colours{0x000000, 0xa4006d, 0x00594c, 0x3d2f9c};

void check(const FieldMap& map)
{
    const std::size_t points = map.x.values.size() * map.y.values.size();
    if (map.values.size() != points)
        throw std::invalid_argument("field map \"" + map.title + "\": " + std::to_string(points) +
                                    " grid points, but " + std::to_string(map.values.size()) + " values");
    if (map.classes.size() > class_colours.size())
        throw std::invalid_argument("field map \"" + map.title + "\": at most six classes, got " +
                                    std::to_string(map.classes.size()));
    for (const double value : map.values)
        if (!map.classes.empty() && !(value >= 0 && value < static_cast<double>(map.classes.size())))
            throw std::invalid_argument("field map \"" + map.title + "\": a value is the index of no class");
    for (const auto& line : map.lines)
        if (line.x.size() != line.y.size())
            throw std::invalid_argument("field map \"" + map.title + "\": a line with " +
                                        std::to_string(line.x.size()) + " x and " + std::to_string(line.y.size()) +
                                        " y values");
}

/// Colours and marks of the number that a map shows.
struct Colouring {
    std::vector<double> positions;
    const ColourTable* table;
    ColourBar bar;
};

Colouring colouring(const FieldMap& map, const Rectangle& plot)
{
    Colouring result{map.values, &viridis_table, {{plot.right() + bar_gap, plot.top, bar_width, plot.height}, {}, ""}};
    if (map.scale == FieldMap::Scale::diverging) {
        const FieldScale scale = field_scale(map.values);
        for (double& v : result.positions) v = scale.at(v);
        result.table = &vik_table;
        result.bar.marks = field_marks(scale, plot.height);
        result.bar.label = axis_label(map.name, map.symbol, map.quantity, map.units, Scale{1, 10, true}).text;
        return result;
    }
    const bool log = map.scale == FieldMap::Scale::log;
    const bool none = std::none_of(map.values.begin(), map.values.end(), [](double v) { return std::isfinite(v); });
    const bool nothing = !none && std::all_of(map.values.begin(), map.values.end(),
                                              [](double v) { return v == 0 || !std::isfinite(v); });
    // of zero everywhere neither a negative nor a large value is meant
    const Scale scale = none ? Scale{1, 10, log} : nothing ? Scale{0, 1, false} : spanning(map.values, log);
    const AxisLabel label = axis_label(map.name, map.symbol, map.quantity, map.units, scale);
    for (double& v : result.positions) v = scale.at(v);
    const Ticks marks = ticks(scale, static_cast<int>(plot.height / 60), label.divisor);
    for (const Tick& tick : marks.major) result.bar.marks.push_back({scale.at(tick.value), tick.label});
    for (const double value : marks.minor) result.bar.marks.push_back({scale.at(value), ""});
    result.bar.label = label.text;
    return result;
}

/// Every pixel has the colour of its class.
Raster class_raster(const RegionRaster& regions, const Rectangle& box)
{
    Raster raster{static_cast<int>(box.width), static_cast<int>(box.height), 3, {}};
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            const Region here = regions.at({box.left + column + 0.5, box.top + row + 0.5});
            const auto index = std::find(class_textures.begin(), class_textures.end(), here) - class_textures.begin();
            const Colour c = from_hex(class_colours[static_cast<std::size_t>(index)]);
            raster.pixels.insert(raster.pixels.end(), {c.red, c.green, c.blue});
        }
    return raster;
}

/// A class ends at the lines of the map, as a region of a stability map ends at its boundaries.
RegionRaster classes_of(const FieldMap& map, const Grid& grid, const std::vector<Polyline>& lines, const Rectangle& box)
{
    std::vector<Region> regions;
    for (const double value : map.values) regions.push_back(class_textures[static_cast<std::size_t>(value)]);
    return RegionRaster(grid, regions, lines, box);
}

/// Values end at the lines, too, as limit cycles do at their fold: not in stairs of the grid.
RegionRaster presence_of(const FieldMap& map, const Grid& grid, const std::vector<Polyline>& lines,
                         const Rectangle& box)
{
    std::vector<Region> regions;
    for (const double value : map.values) regions.push_back(std::isfinite(value) ? Region::stable : Region::undecided);
    return RegionRaster(grid, regions, lines, box);
}

std::string name_of(const FieldMap::Line& line)
{
    return line.boundary && line.name.empty() ? curve_style(*line.boundary).text : line.name;
}

Pen pen_of(const FieldMap& map, std::size_t index)
{
    if (map.lines[index].boundary) return curve_style(*map.lines[index].boundary).pen;
    Pen pen{from_hex(line_colours[index % line_colours.size()]), 2.4, {}};
    if (map.lines[index].dashed) pen.dash = {9, 5};
    return pen;
}

LegendEntry class_entry(Canvas& canvas, Colour colour, Region texture, const std::string& text)
{
    return {[&canvas, colour, texture](const Rectangle& box) {
                canvas.rectangle(box, colour);
                draw_texture(canvas, texture, box, [](Point) { return true; });
                canvas.frame(box, {theme::muted, 0.8});
            },
            text};
}

/// The pieces of a line that is a sign many times, such as the marks of measured rows.
bool are_signs(const std::vector<Polyline>& pieces)
{
    constexpr double largest = 20;
    return !pieces.empty() && std::ranges::all_of(pieces, [](const Polyline& piece) {
        return std::ranges::all_of(piece,
                                   [&](Point p) { return std::hypot(p.x - piece[0].x, p.y - piece[0].y) < largest; });
    });
}

Point middle_of(const Polyline& piece)
{
    const auto [left, right] = std::ranges::minmax(piece, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(piece, {}, &Point::y);
    return {(left.x + right.x) / 2, (low.y + high.y) / 2};
}

/// A line as the legend shows it: a stroke of it, or the first of its signs.
std::vector<Polyline> sample_of(const std::vector<Polyline>& pieces, const Rectangle& box)
{
    const Point here{box.left + box.width / 2, box.top + box.height / 2};
    if (!are_signs(pieces)) return {{{box.left, here.y}, {box.right(), here.y}}};
    const Point first = middle_of(pieces[0]);
    std::vector<Polyline> sign;
    for (Polyline piece : pieces) {
        const Point middle = middle_of(piece);
        if (std::hypot(middle.x - first.x, middle.y - first.y) > 1) continue;
        for (Point& p : piece) p.x += here.x - first.x, p.y += here.y - first.y;
        sign.push_back(std::move(piece));
    }
    return sign;
}

/// `pieces`: what is drawn of each line.
std::vector<LegendEntry> legend(Canvas& canvas, const FieldMap& map, const std::vector<std::vector<Polyline>>& pieces)
{
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < map.lines.size(); ++i)
        entries.push_back({[&canvas, pen = pen_of(map, i), own = pieces[i]](const Rectangle& box) {
                               const auto sample = sample_of(own, box);
                               for (const auto& stroke : sample) canvas.line(stroke, halo_of(pen));
                               for (const auto& stroke : sample) canvas.line(stroke, pen);
                           },
                           name_of(map.lines[i])});
    for (std::size_t i = 0; i < map.classes.size(); ++i)
        if (std::find(map.values.begin(), map.values.end(), static_cast<double>(i)) != map.values.end())
            entries.push_back(class_entry(canvas, from_hex(class_colours[i]), class_textures[i], map.classes[i]));
    if (!map.none.empty() &&
        std::any_of(map.values.begin(), map.values.end(), [](double v) { return !std::isfinite(v); }))
        entries.push_back(class_entry(canvas, no_value, Region::stable, map.none));
    if (map.has_design)
        entries.push_back({[&canvas](const Rectangle& box) {
                               draw_cross(canvas, {box.left + box.width / 2, box.top + box.height / 2});
                           },
                           "design"});
    return entries;
}

}  // namespace

Drawn draw(const FieldMap& map, const std::string& description, const Fonts& fonts)
{
    check(map);
    const Scale x = spanning(map.x.values, map.x.log), y = spanning(map.y.values, map.y.log);
    const Grid grid(map.x, x, map.y, y);
    Canvas canvas(picture_width, fonts);
    const double top =
        draw_heading(canvas, axis_margin, picture_width - axis_margin - 20, map.title, map.fixed, map.statement);
    const Frame frame{{axis_margin, top, plot_width, plot_height},
                      {x, axis_label(map.x.name, map.x.symbol, map.x.quantity, map.units, x)},
                      {y, axis_label(map.y.name, map.y.symbol, map.y.quantity, map.units, y)}};
    Obstacles obstacles;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < map.lines.size(); ++i)
        for (Polyline& piece : visible(map.lines[i].x, map.lines[i].y, frame)) {
            obstacles.lines.push_back(std::move(piece));
            owners.push_back(i);
        }
    if (map.classes.empty()) {
        const Colouring c = colouring(map, frame.box);
        const RegionRaster values = presence_of(map, grid, obstacles.lines, frame.box);
        const auto shown = [&](int column, int row) {
            return values.at({frame.box.left + column + 0.5, frame.box.top + row + 0.5}) == Region::stable;
        };
        canvas.image(frame.box, table_raster(grid, c.positions, *c.table, plot_width, plot_height, shown));
        draw_colour_bar(canvas, c.bar, bar_colours(*c.table));
    } else {
        const RegionRaster regions = classes_of(map, grid, obstacles.lines, frame.box);
        canvas.image(frame.box, class_raster(regions, frame.box));
        for (std::size_t i = 0; i < map.classes.size(); ++i)
            draw_texture(canvas, class_textures[i], frame.box,
                         [&](Point p) { return regions.at(p) == class_textures[i]; });
    }
    for (std::size_t k = 0; k < owners.size(); ++k) canvas.line(obstacles.lines[k], halo_of(pen_of(map, owners[k])));
    for (std::size_t k = 0; k < owners.size(); ++k) canvas.line(obstacles.lines[k], pen_of(map, owners[k]));
    if (map.has_design) draw_design(canvas, frame, map.design, obstacles);
    draw_axes(canvas, frame);
    std::vector<std::vector<Polyline>> pieces(map.lines.size());
    for (std::size_t k = 0; k < owners.size(); ++k) pieces[owners[k]].push_back(obstacles.lines[k]);
    const double bottom = draw_legend(canvas, legend(canvas, map, pieces), frame.box.left,
                                      frame.box.bottom() + axis_depth + 16, picture_width - frame.box.left - 16);
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(map.title), description), "", picture_width, height, frame.box};
}

}  // namespace stickslip::drawing
