// Polylines before they are drawn: cut to a rectangle, thinned to what can be seen, broken into dashes.
#pragma once
#include <vector>

namespace stickslip::drawing {

/// In CSS pixels, y downwards.
struct Point {
    double x = 0, y = 0;

    bool operator==(const Point&) const = default;
};

struct Rectangle {
    double left = 0, top = 0, width = 0, height = 0;

    double right() const { return left + width; }
    double bottom() const { return top + height; }
    bool holds(Point p) const { return p.x >= left && p.x <= right() && p.y >= top && p.y <= bottom(); }
};

using Polyline = std::vector<Point>;

/// The pieces of a polyline inside a rectangle. A point that is not finite breaks the line.
std::vector<Polyline> clip(const Polyline& line, const Rectangle& window);

/// Leaves out points that move the pen less than `tolerance` pixels off the line. In a series that runs left to right
/// the extremes of every pixel column stay, so that no spike is lost.
Polyline thin(const Polyline& line, double tolerance);

/// Whether dashes of a line can be seen: one that crosses itself over and over, as noise about a standstill does, fills
/// its area, and its dashes are more than a reader of pictures takes in a minute.
bool shows_dashes(const Polyline& line, const std::vector<double>& pattern);

/// The pieces in which a line is drawn. One that crosses itself over and over is stroked in short ones: what a renderer
/// does for a path grows with the square of its crossings (librsvg: 4 s for 8000 points of noise, 0.1 s for 1000).
std::vector<Polyline> strokes(const Polyline& line);

/// Ends of the drawn stretches, two points each, for alternating on and off lengths.
std::vector<Point> dashes(const Polyline& line, const std::vector<double>& pattern);

}  // namespace stickslip::drawing
