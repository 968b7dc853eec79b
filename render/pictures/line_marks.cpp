#include "render/pictures/line_marks.h"

#include <cmath>

namespace stickslip::drawing {

void draw_mark(Canvas& canvas, Point at, std::size_t index, Colour colour)
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

std::vector<Point> marked_samples(const Polyline& samples, const Rectangle& window, std::size_t index)
{
    constexpr std::size_t few = 24;
    constexpr double apart = 130, first = 30, shift = 27;
    std::vector<Point> seen;
    for (const Point& p : samples)
        if (std::isfinite(p.x) && std::isfinite(p.y) && window.holds(p)) seen.push_back(p);
    if (seen.size() <= few) return seen;
    std::vector<Point> marked;
    double until_next = first + shift * static_cast<double>(index % 4);
    for (std::size_t i = 1; i < seen.size(); ++i) {
        until_next -= std::hypot(seen[i].x - seen[i - 1].x, seen[i].y - seen[i - 1].y);
        if (until_next > 0) continue;
        marked.push_back(seen[i]);
        until_next = apart;
    }
    return marked;
}

}  // namespace stickslip::drawing
