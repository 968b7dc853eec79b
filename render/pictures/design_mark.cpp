#include "render/pictures/design_mark.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {

void draw_cross(Canvas& canvas, Point at)
{
    const std::vector<Point> arms{{at.x - 8, at.y}, {at.x + 8, at.y}, {at.x, at.y - 8}, {at.x, at.y + 8}};
    const std::vector<Point> rim{{at.x - 10, at.y}, {at.x + 10, at.y}, {at.x, at.y - 10}, {at.x, at.y + 10}};
    canvas.stretches(rim, {field_halo, 6.5});
    canvas.stretches(arms, {field_ink, 2.8});
}

std::vector<Rectangle> draw_design(Canvas& canvas, const Frame& frame, const DesignPoint& design,
                                   const Obstacles& obstacles)
{
    const Point true_place = frame.at(design.x, design.y);
    const Point at{std::clamp(true_place.x, frame.box.left + 11, frame.box.right() - 11),
                   std::clamp(true_place.y, frame.box.top + 11, frame.box.bottom() - 11)};
    const TextStyle style{13.5, field_ink, true, 0, true};
    const std::string text = design.inside ? "design" : "design, beyond the chart";
    const Rectangle place = place_beside(at, canvas.text_width(text, style), label_height, frame.box, obstacles);
    draw_cross(canvas, at);
    canvas.text({place.left, place.top + label_height / 2}, text, style, Across::left, Along::middle);
    return {{at.x - 11, at.y - 11, 22, 22}, place};
}

namespace {

/// Pieces that touch as one line, so that a dash pattern runs on from one to the next.
std::vector<Polyline> joined(std::vector<Polyline> pieces)
{
    constexpr double touch = 0.5;  // px
    const auto near = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y) < touch; };
    std::vector<Polyline> lines;
    for (Polyline& piece : pieces) {
        const auto neighbour = std::find_if(lines.begin(), lines.end(), [&](const Polyline& line) {
            return near(line.back(), piece.front()) || near(line.back(), piece.back());
        });
        if (neighbour == lines.end()) {
            lines.push_back(std::move(piece));
            continue;
        }
        if (!near(neighbour->back(), piece.front())) std::reverse(piece.begin(), piece.end());
        neighbour->insert(neighbour->end(), piece.begin() + 1, piece.end());
    }
    return lines;
}

}  // namespace

std::vector<Polyline> visible(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame)
{
    Polyline line;
    for (std::size_t i = 0; i < x.size(); ++i) line.push_back(frame.at(x[i], y[i]));
    std::vector<Polyline> pieces = joined(clip(line, frame.box));
    for (Polyline& piece : pieces) piece = thin(piece, 0.08);
    return pieces;
}

}  // namespace stickslip::drawing
