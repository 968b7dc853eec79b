// The picture of the whole project: where sliding is smooth, where it is not, and where two theories of friction
// disagree about it.
#include "analysis/results/text.h"
#include "render/axes/frame.h"
#include "render/drawing/markup.h"
#include "render/pictures/design_mark.h"
#include "render/pictures/picture.h"
#include "render/pictures/stability_body.h"

#include <cmath>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900;
constexpr double plot_width = 640, plot_height = 470;

std::string statement(const StabilityMap& map)
{
    std::string text = "The two models agree everywhere on this chart.";
    if (map.disagreement > 0)
        text.assign("The two models disagree on ").append(percent(map.disagreement)) += " of this chart.";
    if (map.undecided > 0) text.append(" ").append(percent(map.undecided)) += " of its points are undecided.";
    return text;
}

std::string_view region_label(Region region, UnsmoothEnd unsmooth)
{
    const auto by_end = [unsmooth](std::string_view sticks, std::string_view mixed, std::string_view rests) {
        return unsmooth == UnsmoothEnd::stick_slip ? sticks : unsmooth == UnsmoothEnd::mixed ? mixed : rests;
    };
    switch (region) {
        case Region::stable:
            return "smooth";
        case Region::memory_only:
            return "smooth, thanks to memory";
        case Region::velocity_only:
            return by_end("stick-slip, due to memory", "stick-slip or rest, due to memory", "rest, due to memory");
        case Region::unstable:
            return by_end("stick-slip", "stick-slip or rest", "rest for good");
        case Region::bistable:
            return "bistable";
        case Region::neutral:
            return "neutral";
        case Region::undecided:
            break;
    }
    return "undecided";
}

/// The name of every region that has room for it, where the room is largest.
void draw_region_labels(Canvas& canvas, const Frame& frame, const DrawnBody& body, UnsmoothEnd unsmooth,
                        Obstacles obstacles)
{
    const TextStyle style{13.5, field_ink, true, 0, true};
    for (const Region region : all_regions) {
        const std::string_view text = region_label(region, unsmooth);
        const auto place =
            roomiest_place(frame.box, canvas.text_width(text, style), label_height, body.covers(region), obstacles);
        if (!place) continue;
        canvas.text({place->left, place->top + label_height / 2}, text, style, Across::left, Along::middle);
        obstacles.boxes.push_back(*place);
    }
}

}  // namespace

Drawn draw(const StabilityMap& map, const std::string& description, const Fonts& fonts)
{
    const Scale x = spanning(map.x.values, map.x.log), y = spanning(map.y.values, map.y.log);
    Canvas canvas(picture_width, fonts);
    const double top =
        draw_heading(canvas, axis_margin, picture_width - axis_margin - 20, map.title, map.fixed, statement(map));
    const Frame frame{{axis_margin, top, plot_width, plot_height},
                      {x, axis_label(map.x.name, map.x.symbol, map.x.quantity, map.units, x)},
                      {y, axis_label(map.y.name, map.y.symbol, map.y.quantity, map.units, y)}};
    const FieldScale scale = field_scale(map.abscissa);
    const StabilityBody body{map.x, map.y, map.abscissa, map.region, map.curves};
    const DrawnBody drawn = draw_body(canvas, frame, body, scale, map.title);
    Obstacles obstacles = drawn.obstacles;
    if (map.has_design) obstacles.boxes = draw_design(canvas, frame, map.design, obstacles);
    draw_region_labels(canvas, frame, drawn, unsmooth_end(map), obstacles);
    draw_axes(canvas, frame);
    draw_body_bar(canvas, frame.box, scale);
    const double bottom =
        draw_legend(canvas, body_legend(canvas, {body}, map.has_design, unsmooth_end(map)), frame.box.left,
                    frame.box.bottom() + axis_depth + 16, picture_width - frame.box.left - 16);
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(map.title), description), "", picture_width, height, frame.box, {}};
}

}  // namespace stickslip::drawing
