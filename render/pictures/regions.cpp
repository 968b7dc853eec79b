#include "render/pictures/regions.h"

#include "analysis/results/rests.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

constexpr double step = 1.5;  // px between the places where a hatch line looks whether it is still inside

/// Stretches of the parallel lines at ±45° that are covered; `rising` goes from lower left to upper right.
std::vector<Point> hatch(const Rectangle& box, double distance, bool rising, const Covers& covered)
{
    std::vector<Point> ends;
    const double sign = rising ? -1 : 1, apart = distance * std::sqrt(2.0);
    // Lines y = sign·x + offset. Offsets are multiples of the distance from the canvas origin: swatches match the map.
    const double a = box.top - sign * box.left, b = box.top - sign * box.right();
    const double lowest = std::min(a, b), highest = std::max(a, b) + box.height;
    for (double offset = std::ceil(lowest / apart) * apart; offset <= highest; offset += apart) {
        bool drawing = false;
        Point last;
        for (double x = box.left; x <= box.right(); x += step) {
            const Point here{x, sign * x + offset};
            const bool inside = box.holds(here) && covered(here);
            if (inside && !drawing) ends.push_back(here);
            if (!inside && drawing) ends.push_back(last);
            drawing = inside;
            last = here;
        }
        if (drawing) ends.push_back(last);
    }
    return ends;
}

/// Points of a staggered lattice that are covered, with a margin to the box's edges.
std::vector<Point> lattice(const Rectangle& box, double distance, const Covers& covered)
{
    std::vector<Point> points;
    bool shifted = false;
    for (double y = box.top + distance / 2; y < box.bottom(); y += distance, shifted = !shifted)
        for (double x = box.left + distance * (shifted ? 1.0 : 0.5); x < box.right() - 2; x += distance)
            if (covered({x, y})) points.push_back({x, y});
    return points;
}

std::vector<Point> moved(std::vector<Point> points, double dx, double dy)
{
    for (Point& p : points) p = {p.x + dx, p.y + dy};
    return points;
}

void crosses(Canvas& canvas, const std::vector<Point>& points, double arm, const Pen& pen)
{
    std::vector<Point> ends;
    for (const Point& p : points) {
        ends.insert(ends.end(), {{p.x - arm, p.y - arm}, {p.x + arm, p.y + arm}});
        ends.insert(ends.end(), {{p.x - arm, p.y + arm}, {p.x + arm, p.y - arm}});
    }
    canvas.stretches(ends, pen);
}

}  // namespace

std::string_view region_name(Region region)
{
    switch (region) {
        case Region::stable:
            return "stable";
        case Region::memory_only:
            return "memory-only";
        case Region::velocity_only:
            return "velocity-only";
        case Region::unstable:
            return "unstable";
        case Region::bistable:
            return "bistable";
        case Region::neutral:
            return "neutral";
        case Region::undecided:
            break;
    }
    return "undecided";
}

UnsmoothEnd unsmooth_end(const StabilityMap& map)
{
    const auto rests = rests_of(map.readings);
    std::size_t still = 0, unsmooth = 0;
    for (std::size_t i = 0; i < rests.size(); ++i) {
        const auto region = map.region[i];
        still += rests[i];
        unsmooth += region == Region::unstable || region == Region::velocity_only || region == Region::bistable;
    }
    return still == 0 ? UnsmoothEnd::stick_slip : still < unsmooth ? UnsmoothEnd::mixed : UnsmoothEnd::rest;
}

std::string_view region_text(Region region, UnsmoothEnd unsmooth)
{
    const auto by_end = [unsmooth](std::string_view sticks, std::string_view mixed, std::string_view rests) {
        return unsmooth == UnsmoothEnd::stick_slip ? sticks : unsmooth == UnsmoothEnd::mixed ? mixed : rests;
    };
    switch (region) {
        case Region::stable:
            return "smooth in both models";
        case Region::memory_only:
            return "smooth with memory only";
        case Region::velocity_only:
            return by_end("stick-slip with memory only", "stick-slip or rest for good with memory only",
                          "rest for good with memory only");
        case Region::unstable:
            return by_end("stick-slip in both models", "unstable in both models: stick-slip, or rest for good",
                          "unstable in both models: rest for good");
        case Region::bistable:
            return by_end("bistable: a larger disturbance ends in stick-slip",
                          "bistable: a larger disturbance ends in stick-slip, or at rest for good",
                          "bistable: a larger disturbance ends at rest for good");
        case Region::neutral:
            return "neutral: small disturbances neither decay nor grow";
        case Region::undecided:
            break;
    }
    return "undecided";
}

void draw_texture(Canvas& canvas, Region region, const Rectangle& box, const Covers& covered)
{
    constexpr Colour black = field_ink, white = field_halo, gold = from_hex(0xffdd33);
    const auto shade = [](Colour c, double opacity) { return Colour{c.red, c.green, c.blue, opacity}; };
    switch (region) {
        case Region::stable:
            break;
        case Region::memory_only: {  // the paper's second regime: meant to be seen first
            const auto ends = hatch(box, 11, true, covered);
            canvas.stretches(ends, {shade(black, 0.5), 2.8});
            canvas.stretches(ends, {gold, 1.5});
            break;
        }
        case Region::velocity_only: {
            auto ends = hatch(box, 9, true, covered);
            const auto others = hatch(box, 9, false, covered);
            ends.insert(ends.end(), others.begin(), others.end());
            canvas.stretches(ends, {shade(white, 0.75), 2.4});
            canvas.stretches(ends, {shade(black, 0.85), 1});
            break;
        }
        case Region::unstable: {
            const auto ends = hatch(box, 10, false, covered);
            canvas.stretches(moved(ends, 0.8, -0.8), {shade(white, 0.35), 0.8});
            canvas.stretches(ends, {shade(black, 0.42), 0.9});
            break;
        }
        case Region::bistable: {
            std::vector<Point> ends;
            for (const Point& p : lattice(box, 10, covered))
                ends.insert(ends.end(), {{p.x - 1.5, p.y}, {p.x + 1.5, p.y}});
            canvas.stretches(ends, {shade(white, 0.8), 4.4});
            canvas.stretches(ends, {black, 3});
            break;
        }
        case Region::neutral: {
            std::vector<Point> ends;
            for (const Point& p : lattice(box, 11, covered)) ends.insert(ends.end(), {{p.x - 3, p.y}, {p.x + 3, p.y}});
            canvas.stretches(ends, {shade(white, 0.75), 2.4});
            canvas.stretches(ends, {shade(black, 0.85), 1});
            break;
        }
        case Region::undecided:
            crosses(canvas, lattice(box, 9, covered), 2, {shade(black, 0.75), 0.9});
            break;
    }
}

double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, double left, double top, double width)
{
    constexpr double swatch_width = 34, swatch_height = 16, line_height = 25, gap = 9, between = 26;
    constexpr TextStyle style{12.5};
    std::vector<double> widths;
    for (const auto& entry : entries) widths.push_back(swatch_width + gap + canvas.text_width(entry.text, style));

    // As many columns, filled downwards, as fit; each as wide as its widest entry.
    std::size_t rows = 1;
    std::vector<double> starts;
    for (;; ++rows) {
        starts = {left};
        for (std::size_t first = 0; first < entries.size(); first += rows) {
            const auto end = widths.begin() + static_cast<std::ptrdiff_t>(std::min(first + rows, entries.size()));
            starts.push_back(starts.back() + between +
                             *std::max_element(widths.begin() + static_cast<std::ptrdiff_t>(first), end));
        }
        if (starts.back() - between <= left + width || rows >= entries.size()) break;
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const double x = starts[i / rows], y = top + static_cast<double>(i % rows) * line_height;
        entries[i].swatch({x, y, swatch_width, swatch_height});
        canvas.text({x + swatch_width + gap, y + swatch_height / 2}, entries[i].text, style, Across::left,
                    Along::middle);
    }
    return top + static_cast<double>(entries.empty() ? 0 : rows) * line_height;
}

}  // namespace stickslip::drawing
