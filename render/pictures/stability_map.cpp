// The picture of the whole project: where sliding is smooth, where it is not, and where two theories of friction
// disagree about it.
#include "analysis/results/text.h"
#include "render/axes/frame.h"
#include "render/drawing/colour_map.h"
#include "render/drawing/markup.h"
#include "render/pictures/design_mark.h"
#include "render/pictures/field.h"
#include "render/pictures/picture.h"
#include "render/pictures/placement.h"
#include "render/pictures/regions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900;
constexpr double plot_width = 640, plot_height = 470, bar_gap = 24, bar_width = 17;

struct CurveStyle {
    Pen pen;
    const char* text;
};

CurveStyle curve_style(Curve::Kind kind)
{
    switch (kind) {
        case Curve::Kind::velocity_only:
            return {{from_hex(0xa4006d), 2.6, {9, 5}}, "boundary, velocity-only theory"};
        case Curve::Kind::state_variable:
            return {{field_ink, 2.6}, "boundary, with frictional memory"};
        case Curve::Kind::fold:
            return {{from_hex(0x00594c), 2.4, {10, 4, 2, 4}}, "fold of limit cycles"};
        case Curve::Kind::outcome:
            break;
    }
    return {{from_hex(0x3d2f9c), 2.2, {2.5, 3}}, "boundary, nonlinear simulation"};
}

Pen halo_of(const CurveStyle& style)
{
    return {field_halo, style.pen.width + 3, {}};
}

void check(const StabilityMap& map)
{
    const std::size_t points = map.x.values.size() * map.y.values.size();
    if (map.abscissa.size() != points || map.region.size() != points)
        throw std::invalid_argument("stability map \"" + map.title + "\": " + std::to_string(points) +
                                    " grid points, but " + std::to_string(map.abscissa.size()) + " abscissas and " +
                                    std::to_string(map.region.size()) + " regions");
    for (const Curve& curve : map.curves)
        if (curve.x.size() != curve.y.size())
            throw std::invalid_argument("stability map \"" + map.title + "\": a curve with " +
                                        std::to_string(curve.x.size()) + " x and " + std::to_string(curve.y.size()) +
                                        " y values");
}

std::string statement(const StabilityMap& map)
{
    std::string text = "The two theories agree everywhere on this chart.";
    if (map.disagreement > 0)
        text.assign("The two theories disagree on ").append(percent(map.disagreement)) += " of this chart.";
    if (map.undecided > 0) text.append(" ").append(percent(map.undecided)) += " of its points are undecided.";
    return text;
}

std::string_view region_label(Region region)
{
    switch (region) {
        case Region::stable:
            return "smooth";
        case Region::memory_only:
            return "smooth, thanks to memory";
        case Region::velocity_only:
            return "stick-slip, due to memory";
        case Region::unstable:
            return "stick-slip";
        case Region::bistable:
            return "bistable";
        case Region::undecided:
            break;
    }
    return "undecided";
}

/// The name of every region that has room for it, where the room is largest.
void draw_region_labels(Canvas& canvas, const Frame& frame, const std::vector<Covers>& covered, Obstacles obstacles)
{
    const TextStyle style{13.5, field_ink, true, 0, true};
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const std::string_view text = region_label(all_regions[i]);
        const auto place =
            roomiest_place(frame.box, canvas.text_width(text, style), label_height, covered[i], obstacles);
        if (!place) continue;
        canvas.text({place->left, place->top + label_height / 2}, text, style, Across::left, Along::middle);
        obstacles.boxes.push_back(*place);
    }
}

/// Typical colour of a region for its swatch: the sign of the abscissa that defines it.
Colour swatch_colour(Region region)
{
    switch (region) {
        case Region::velocity_only:
        case Region::unstable:
            return sample(vik_table, 0.7);
        case Region::undecided:
            return no_value;
        default:
            return sample(vik_table, 0.32);
    }
}

std::vector<LegendEntry> legend(Canvas& canvas, const StabilityMap& map)
{
    std::vector<LegendEntry> entries;
    for (const auto kind :
         {Curve::Kind::state_variable, Curve::Kind::velocity_only, Curve::Kind::fold, Curve::Kind::outcome})
        if (std::any_of(map.curves.begin(), map.curves.end(), [kind](const Curve& c) { return c.kind == kind; }))
            entries.push_back({[&canvas, kind](const Rectangle& box) {
                                   const double y = box.top + box.height / 2;
                                   const Polyline line{{box.left, y}, {box.right(), y}};
                                   canvas.line(line, halo_of(curve_style(kind)));
                                   canvas.line(line, curve_style(kind).pen);
                               },
                               curve_style(kind).text});
    for (const Region region : all_regions)
        if (std::find(map.region.begin(), map.region.end(), region) != map.region.end())
            entries.push_back({[&canvas, region](const Rectangle& box) {
                                   canvas.rectangle(box, swatch_colour(region));
                                   draw_texture(canvas, region, box, [](Point) { return true; });
                                   canvas.frame(box, {theme::muted, 0.8});
                               },
                               std::string(region_text(region))});
    if (map.has_design)
        entries.push_back({[&canvas](const Rectangle& box) {
                               draw_cross(canvas, {box.left + box.width / 2, box.top + box.height / 2});
                           },
                           "design"});
    return entries;
}

ColourBar colour_bar(const Rectangle& plot, const FieldScale& scale)
{
    const double height = plot.height;
    return {{plot.right() + bar_gap, plot.top, bar_width, height},
            field_marks(scale, height),
            "spectral abscissa max Re s [1/s], asinh scale"};
}

}  // namespace

Drawn draw(const StabilityMap& map, const std::string& description, const Fonts& fonts)
{
    check(map);
    const Scale x = spanning(map.x.values, map.x.log), y = spanning(map.y.values, map.y.log);
    const Grid grid(map.x, x, map.y, y);
    Canvas canvas(picture_width, fonts);
    const double top =
        draw_heading(canvas, axis_margin, picture_width - axis_margin - 20, map.title, map.fixed, statement(map));
    const Frame frame{{axis_margin, top, plot_width, plot_height},
                      {x, axis_label(map.x.name, map.x.symbol, map.x.quantity, map.motion, x)},
                      {y, axis_label(map.y.name, map.y.symbol, map.y.quantity, map.motion, y)}};

    const FieldScale scale = field_scale(map.abscissa);
    canvas.image(frame.box, field_raster(grid, map.abscissa, scale, plot_width, plot_height));
    std::vector<Covers> covered;
    for (const Region region : all_regions) {
        covered.push_back(covers(grid, map.region, region, frame.box));
        draw_texture(canvas, region, frame.box, covered.back());
    }
    // All rims first: no curve may cut into another one.
    Obstacles obstacles;
    std::vector<CurveStyle> styles;
    for (const Curve& curve : map.curves)
        for (const Polyline& piece : visible(curve.x, curve.y, frame)) {
            obstacles.lines.push_back(piece);
            styles.push_back(curve_style(curve.kind));
            canvas.line(piece, halo_of(styles.back()));
        }
    for (std::size_t i = 0; i < styles.size(); ++i) canvas.line(obstacles.lines[i], styles[i].pen);
    if (map.has_design) obstacles.boxes = draw_design(canvas, frame, map.design, obstacles);
    draw_region_labels(canvas, frame, covered, obstacles);
    draw_axes(canvas, frame);
    draw_colour_bar(canvas, colour_bar(frame.box, scale), bar_colours(vik_table));
    const double bottom = draw_legend(canvas, legend(canvas, map), frame.box.left, frame.box.bottom() + axis_depth + 16,
                                      picture_width - frame.box.left - 16);
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(map.title), description), "", picture_width, height, frame.box};
}

}  // namespace stickslip::drawing
