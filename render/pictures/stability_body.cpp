#include "render/pictures/stability_body.h"

#include "render/drawing/colour_map.h"
#include "render/pictures/curve_style.h"
#include "render/pictures/design_mark.h"

#include <algorithm>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr double bar_gap = 24, bar_width = 17;

/// Solid first: where two boundaries coincide, both show.
constexpr Curve::Kind drawing_order[] = {Curve::Kind::state_variable, Curve::Kind::ideal_loop,
                                         Curve::Kind::velocity_only, Curve::Kind::fold, Curve::Kind::outcome};

void check(const StabilityBody& body, const std::string& title)
{
    const std::size_t points = body.x.values.size() * body.y.values.size();
    if (body.abscissa.size() != points || body.region.size() != points)
        throw std::invalid_argument("stability map \"" + title + "\": " + std::to_string(points) +
                                    " grid points, but " + std::to_string(body.abscissa.size()) + " abscissas and " +
                                    std::to_string(body.region.size()) + " regions");
    for (const Curve& curve : body.curves)
        if (curve.x.size() != curve.y.size())
            throw std::invalid_argument("stability map \"" + title + "\": a curve with " +
                                        std::to_string(curve.x.size()) + " x and " + std::to_string(curve.y.size()) +
                                        " y values");
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
        case Region::neutral:
            return sample(vik_table, 0.5);
        default:
            return sample(vik_table, 0.32);
    }
}

}  // namespace

Covers DrawnBody::covers(Region region) const
{
    return [raster = regions, region](Point p) { return raster->at(p) == region; };
}

DrawnBody draw_body(Canvas& canvas, const Frame& frame, const StabilityBody& body, const FieldScale& scale,
                    const std::string& title)
{
    check(body, title);
    const Grid grid(body.x, frame.x.scale, body.y, frame.y.scale);
    canvas.image(frame.box, field_raster(grid, body.abscissa, scale, static_cast<int>(frame.box.width),
                                         static_cast<int>(frame.box.height)));
    DrawnBody drawn;
    std::vector<CurveStyle> styles;
    for (const auto kind : drawing_order)
        for (const Curve& curve : body.curves) {
            if (curve.kind != kind) continue;
            for (Polyline& piece : visible(curve.x, curve.y, frame)) {
                drawn.obstacles.lines.push_back(std::move(piece));
                styles.push_back(curve_style(kind));
            }
        }
    drawn.regions = std::make_shared<RegionRaster>(grid, body.region, drawn.obstacles.lines, frame.box);
    for (const Region region : all_regions)
        if (std::find(body.region.begin(), body.region.end(), region) != body.region.end())
            draw_texture(canvas, region, frame.box, drawn.covers(region));
    // All rims first: no curve may cut into another one.
    for (std::size_t i = 0; i < styles.size(); ++i) canvas.line(drawn.obstacles.lines[i], halo_of(styles[i].pen));
    for (std::size_t i = 0; i < styles.size(); ++i) canvas.line(drawn.obstacles.lines[i], styles[i].pen);
    return drawn;
}

std::vector<LegendEntry> body_legend(Canvas& canvas, const std::vector<StabilityBody>& bodies, bool has_design,
                                     UnsmoothEnd unsmooth)
{
    std::vector<LegendEntry> entries;
    const auto occurs = [&](auto in) { return std::any_of(bodies.begin(), bodies.end(), in); };
    for (const auto kind : drawing_order)
        if (occurs([kind](const StabilityBody& b) {
                return std::any_of(b.curves.begin(), b.curves.end(), [kind](const Curve& c) { return c.kind == kind; });
            }))
            entries.push_back({[&canvas, kind](const Rectangle& box) {
                                   const double y = box.top + box.height / 2;
                                   const Polyline line{{box.left, y}, {box.right(), y}};
                                   canvas.line(line, halo_of(curve_style(kind).pen));
                                   canvas.line(line, curve_style(kind).pen);
                               },
                               curve_style(kind).text});
    for (const Region region : all_regions)
        if (occurs([region](const StabilityBody& b) {
                return std::find(b.region.begin(), b.region.end(), region) != b.region.end();
            }))
            entries.push_back({[&canvas, region](const Rectangle& box) {
                                   canvas.rectangle(box, swatch_colour(region));
                                   draw_texture(canvas, region, box, [](Point) { return true; });
                                   canvas.frame(box, {theme::muted, 0.8, {}});
                               },
                               std::string(region_text(region, unsmooth))});
    if (has_design)
        entries.push_back({[&canvas](const Rectangle& box) {
                               draw_cross(canvas, {box.left + box.width / 2, box.top + box.height / 2});
                           },
                           "design"});
    return entries;
}

void draw_body_bar(Canvas& canvas, const Rectangle& plot, const FieldScale& scale)
{
    draw_colour_bar(canvas,
                    {{plot.right() + bar_gap, plot.top, bar_width, plot.height},
                     field_marks(scale, plot.height),
                     "spectral abscissa max Re s [1/s], asinh scale"},
                    bar_colours(vik_table));
}

}  // namespace stickslip::drawing
