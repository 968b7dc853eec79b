#include "render/pictures/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::drawing {
namespace {

Rectangle grown(const Rectangle& r, double by)
{
    return {r.left - by, r.top - by, r.width + 2 * by, r.height + 2 * by};
}

bool overlap(const Rectangle& a, const Rectangle& b)
{
    return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

bool contains(const Rectangle& outer, const Rectangle& inner)
{
    return inner.left >= outer.left && inner.right() <= outer.right() && inner.top >= outer.top &&
           inner.bottom() <= outer.bottom();
}

bool filled(const Rectangle& r, const Covers& covered)
{
    constexpr int columns = 8, rows = 4;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            if (!covered({r.left + r.width * i / columns, r.top + r.height * j / rows})) return false;
    return true;
}

}  // namespace

int Obstacles::touched(const Rectangle& place) const
{
    int count = 0;
    for (const Polyline& line : lines) count += clip(line, place).empty() ? 0 : 1;
    for (const Rectangle& box : boxes) count += overlap(box, place) ? 1 : 0;
    return count;
}

std::optional<Rectangle> roomiest_place(const Rectangle& box, double width, double height, const Covers& covered,
                                        const Obstacles& obstacles)
{
    constexpr double step = 12;
    constexpr double margins[] = {5, 12, 22, 36, 54, 80, 120};
    std::size_t best_margin = 0;  // how many of the margins the best places have
    std::vector<Rectangle> best;
    for (double y = box.top; y + height <= box.bottom(); y += step)
        for (double x = box.left; x + width <= box.right(); x += step) {
            const Rectangle place{x, y, width, height};
            std::size_t have = 0;
            for (; have < std::size(margins); ++have) {
                const Rectangle wide = grown(place, margins[have]);
                if (!contains(box, wide) || !filled(wide, covered) || obstacles.touched(wide)) break;
            }
            if (have == 0 || have < best_margin) continue;
            if (have > best_margin) best.clear();
            best_margin = have;
            best.push_back(place);
        }
    if (best.empty()) return std::nullopt;
    Point middle;
    for (const Rectangle& r : best) middle = {middle.x + r.left, middle.y + r.top};
    middle = {middle.x / static_cast<double>(best.size()), middle.y / static_cast<double>(best.size())};
    const auto distance = [&](const Rectangle& r) { return std::hypot(r.left - middle.x, r.top - middle.y); };
    return *std::min_element(best.begin(), best.end(),
                             [&](const Rectangle& a, const Rectangle& b) { return distance(a) < distance(b); });
}

Rectangle place_beside(Point point, double width, double height, const Rectangle& box, const Obstacles& obstacles)
{
    constexpr double beside = 14, above = 20;
    Rectangle best;
    int fewest = std::numeric_limits<int>::max();
    for (const double dy : {-above, above, 0.0})
        for (const double dx : {beside, -beside - width, -width / 2, 8 - width}) {
            if (dy == 0 && std::abs(dx + width / 2) < width / 2 + beside / 2) continue;  // over the point itself
            const Rectangle place{point.x + dx, point.y + dy - height / 2, width, height};
            const int cost = obstacles.touched(grown(place, 2)) + (contains(grown(box, -3), place) ? 0 : 1000);
            if (cost < fewest) {
                fewest = cost;
                best = place;
            }
        }
    return best;
}

}  // namespace stickslip::drawing
