#include "render/pictures/region_raster.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

constexpr double cell = 2;     // px: finer than a hatch line
constexpr double bucket = 16;  // px

struct Stretch {
    Point from, to;
};

double turn(Point a, Point b, Point c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Touching counts: a node on the boundary itself speaks for neither side.
bool cross(const Stretch& s, const Stretch& t)
{
    return turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) <= 0 &&
           turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) <= 0;
}

/// Boundaries in short stretches, found by the square that they run through.
class Fences {
  public:
    Fences(const std::vector<Polyline>& lines, const Rectangle& box)
        : box_(box),
          columns_(static_cast<std::size_t>(box.width / bucket) + 1),
          squares_(columns_ * (static_cast<std::size_t>(box.height / bucket) + 1))
    {
        for (const Polyline& line : lines)
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                const Point a = line[i], b = line[i + 1];
                const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / bucket);
                const auto at = [&](int k) {
                    return Point{a.x + (b.x - a.x) * k / pieces, a.y + (b.y - a.y) * k / pieces};
                };
                for (int k = 0; k < pieces; ++k) {
                    const Stretch piece{at(k), at(k + 1)};
                    for (const std::size_t square : around(piece)) squares_[square].push_back(piece);
                }
            }
    }

    bool between(Point p, Point q) const
    {
        const Stretch way{p, q};
        for (const std::size_t square : around(way))
            for (const Stretch& s : squares_[square])
                if (cross(s, way)) return true;
        return false;
    }

  private:
    /// The squares that its bounding box touches.
    std::vector<std::size_t> around(const Stretch& s) const
    {
        const auto place = [](double v, double from, double length) {
            return static_cast<std::size_t>(std::clamp(v - from, 0.0, length) / bucket);
        };
        const auto left = place(std::min(s.from.x, s.to.x), box_.left, box_.width);
        const auto right = place(std::max(s.from.x, s.to.x), box_.left, box_.width);
        const auto top = place(std::min(s.from.y, s.to.y), box_.top, box_.height);
        const auto bottom = place(std::max(s.from.y, s.to.y), box_.top, box_.height);
        std::vector<std::size_t> squares;
        for (auto j = top; j <= bottom; ++j)
            for (auto i = left; i <= right; ++i) squares.push_back(j * columns_ + i);
        return squares;
    }

    Rectangle box_;
    std::size_t columns_;
    std::vector<std::vector<Stretch>> squares_;
};

}  // namespace

RegionRaster::RegionRaster(const Grid& grid, const std::vector<Region>& regions,
                           const std::vector<Polyline>& boundaries, const Rectangle& box)
    : box_(box),
      columns_(static_cast<std::size_t>(std::ceil(box.width / cell))),
      rows_(static_cast<std::size_t>(std::ceil(box.height / cell)))
{
    const Fences fences(boundaries, box);
    cells_.reserve(columns_ * rows_);
    for (std::size_t j = 0; j < rows_; ++j)
        for (std::size_t i = 0; i < columns_; ++i) {
            const double across = (static_cast<double>(i) + 0.5) / static_cast<double>(columns_);
            const double up = 1 - (static_cast<double>(j) + 0.5) / static_cast<double>(rows_);
            Grid::Place place = grid.at(across, up);
            const Region first = regions[place.node[0]];
            if (std::all_of(place.node.begin(), place.node.end(), [&](auto n) { return regions[n] == first; })) {
                cells_.push_back(first);
                continue;
            }
            const Point here{box.left + across * box.width, box.bottom() - up * box.height};
            Region found = regions[place.nearest()];
            for (int tried = 0; tried < 4; ++tried) {
                const std::size_t k = static_cast<std::size_t>(
                    std::max_element(place.weight.begin(), place.weight.end()) - place.weight.begin());
                const auto [x, y] = grid.position(place.node[k]);
                if (!fences.between(here, {box.left + x * box.width, box.bottom() - y * box.height})) {
                    found = regions[place.node[k]];
                    break;
                }
                place.weight[k] = -1;
            }
            cells_.push_back(found);
        }
}

Region RegionRaster::at(Point p) const
{
    const auto index = [](double position, std::size_t count) {
        return static_cast<std::size_t>(
            std::clamp(position * static_cast<double>(count), 0.0, static_cast<double>(count - 1)));
    };
    return cells_[index((p.y - box_.top) / box_.height, rows_) * columns_ +
                  index((p.x - box_.left) / box_.width, columns_)];
}

}  // namespace stickslip::drawing
