#include "render/drawing/polyline.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

/// Liang and Barsky: the parameters between which the segment a→b lies inside, or false.
bool inside_stretch(Point a, Point b, const Rectangle& window, double& from, double& to)
{
    from = 0;
    to = 1;
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double direction[] = {-dx, dx, -dy, dy};
    const double room[] = {a.x - window.left, window.right() - a.x, a.y - window.top, window.bottom() - a.y};
    for (int side = 0; side < 4; ++side) {
        if (direction[side] == 0) {
            if (room[side] < 0) return false;
            continue;
        }
        const double t = room[side] / direction[side];
        if (direction[side] < 0)
            from = std::max(from, t);
        else
            to = std::min(to, t);
        if (from > to) return false;
    }
    return true;
}

bool runs_left_to_right(const Polyline& line)
{
    return std::is_sorted(line.begin(), line.end(), [](Point a, Point b) { return a.x < b.x; });
}

/// First, lowest, highest and last point of every column of the given width.
Polyline column_extremes(const Polyline& line, double width)
{
    Polyline kept;
    for (std::size_t first = 0; first < line.size();) {
        const double column = std::floor(line[first].x / width);
        std::size_t last = first, low = first, high = first;
        for (std::size_t i = first; i < line.size() && std::floor(line[i].x / width) == column; ++i) {
            if (line[i].y < line[low].y) low = i;
            if (line[i].y > line[high].y) high = i;
            last = i;
        }
        std::size_t chosen[] = {first, std::min(low, high), std::max(low, high), last};
        for (std::size_t k = 0; k < 4; ++k)
            if (k == 0 || chosen[k] != chosen[k - 1]) kept.push_back(line[chosen[k]]);
        first = last + 1;
    }
    return kept;
}

double distance_to_chord(Point p, Point a, Point b)
{
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
    const double along = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (length * length), 0.0, 1.0);
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Ramer, Douglas and Peucker, with a stack of its own so that a long record cannot exhaust the call stack.
Polyline straightened(const Polyline& line, double tolerance)
{
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        std::size_t farthest = a;
        double distance = tolerance;
        for (std::size_t i = a + 1; i < b; ++i)
            if (const double d = distance_to_chord(line[i], line[a], line[b]); d > distance) {
                distance = d;
                farthest = i;
            }
        if (farthest == a) continue;
        keep[farthest] = true;
        open.push_back({a, farthest});
        open.push_back({farthest, b});
    }
    Polyline kept;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (keep[i]) kept.push_back(line[i]);
    return kept;
}

}  // namespace

std::vector<Polyline> clip(const Polyline& line, const Rectangle& window)
{
    std::vector<Polyline> pieces;
    const auto finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    bool connected = false;  // whether the last piece ends exactly at the next segment's start
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        double from = 0, to = 1;
        if (!finite(a) || !finite(b) || !inside_stretch(a, b, window, from, to)) {
            connected = false;
            continue;
        }
        const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
        if (!connected || from > 0) pieces.push_back({from > 0 ? at(from) : a});
        pieces.back().push_back(to < 1 ? at(to) : b);
        connected = to == 1;
    }
    return pieces;
}

Polyline thin(const Polyline& line, double tolerance)
{
    if (line.size() < 3) return line;
    constexpr std::size_t dense = 4000;  // below, the quadratic worst case of straightening is no matter
    const bool columns = line.size() > dense && runs_left_to_right(line);
    return straightened(columns ? column_extremes(line, 0.5) : line, tolerance);
}

bool shows_dashes(const Polyline& line, const std::vector<double>& pattern)
{
    constexpr double most = 5000;  // dashes; a page is some hundred long
    double length = 0, period = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    for (const double part : pattern) period += part;
    return period > 0 && length < most * period;
}

std::vector<Polyline> strokes(const Polyline& line)
{
    constexpr std::size_t few = 1500, short_piece = 400;
    if (line.size() <= few || runs_left_to_right(line)) return {line};
    std::vector<Polyline> pieces;
    for (std::size_t from = 0; from + 1 < line.size(); from += short_piece) {
        const std::size_t end = std::min(from + short_piece + 1, line.size());  // a piece begins where the last ends
        pieces.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(from),
                            line.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return pieces;
}

std::vector<Point> dashes(const Polyline& line, const std::vector<double>& pattern)
{
    std::vector<Point> ends;
    std::size_t part = 0;
    double left = pattern.empty() ? 0 : pattern.front();
    for (std::size_t i = 0; i + 1 < line.size() && !pattern.empty(); ++i) {
        const Point a = line[i], b = line[i + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        for (double done = 0; done < length;) {
            const double step = std::min(left, length - done), next = done + step;
            if (part % 2 == 0) {
                const auto at = [&](double s) {
                    return Point{a.x + s / length * (b.x - a.x), a.y + s / length * (b.y - a.y)};
                };
                ends.push_back(at(done));
                ends.push_back(at(next));
            }
            done = next;
            left -= step;
            if (left <= 0) left = pattern[++part % pattern.size()];
        }
    }
    return ends;
}

}  // namespace stickslip::drawing
