#include "sweep/study/beyond_curves.h"

#include "analysis/boundary/trace/chart.h"
#include "sweep/study/maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>

namespace stickslip {
namespace {

enum class Side : std::uint8_t { unknown, free, cycles };

/// A straight piece of a curve in scaled coordinates, and whether cycles lie above it (to its right, along u).
struct Stretch {
    UnitPoint from, to;
    bool along_y;
    bool cycles_above;

    Side side_of(UnitPoint p) const
    {
        const UnitPoint way = to - from;
        const double left = way.cross(p - from);
        const bool above = along_y ? left * way.u > 0 : left * way.v < 0;
        return above == cycles_above ? Side::cycles : Side::free;
    }
    bool between(UnitPoint p, UnitPoint q) const
    {
        const UnitPoint way = to - from, edge = q - p;
        return (way.cross(p - from) < 0) != (way.cross(q - from) < 0) &&
               (edge.cross(from - p) < 0) != (edge.cross(to - p) < 0);
    }
};

bool linearly_stable(Region region)
{
    return region == Region::stable || region == Region::memory_only || region == Region::bistable;
}

bool ends_in_doubt(const FollowedBoundary& curve)
{
    const auto doubtful = [](CurveEnd end) { return end == CurveEnd::undecided || end == CurveEnd::lost; };
    return std::any_of(curve.pieces.begin(), curve.pieces.end(),
                       [&](const CurvePiece& piece) { return doubtful(piece.first) || doubtful(piece.last); });
}

/// The sides of the nodes of one map for one curve.
class Sides {
  public:
    Sides(const StabilityMap& map, const FollowedBoundary& curve)
        : map_(map), x_(curve.x), y_(curve.y), columns_(map.x.values.size()), nodes_(map.region.size())
    {
        for (const auto& piece : curve.pieces)
            for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
                const auto &p = piece.points[i], &q = piece.points[i + 1];
                const UnitPoint from{x_.unit(p.x), y_.unit(p.y)}, to{x_.unit(q.x), y_.unit(q.y)};
                const double runs = p.along_y ? to.u - from.u : to.v - from.v;
                if (p.at.direction != 0 && runs != 0) stretches_.push_back({from, to, p.along_y, p.at.direction > 0});
            }
        spread();
    }

    Side at(std::size_t node) const { return nodes_[node]; }

    /// At any place: that of a corner of its cell from which no curve parts it.
    Side at(double x, double y) const
    {
        const UnitPoint p{x_.unit(x), y_.unit(y)};
        const auto cell = [](const std::vector<double>& values, double v) {
            const auto above = std::upper_bound(values.begin(), values.end(), v) - values.begin();
            return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(values) - 2));
        };
        const std::size_t lower = cell(map_.y.values, y) * columns_ + cell(map_.x.values, x);
        for (const auto node : {lower, lower + 1, lower + columns_, lower + columns_ + 1})
            if (nodes_[node] != Side::unknown && !parting(p, place(node))) return nodes_[node];
        return Side::unknown;
    }

  private:
    UnitPoint place(std::size_t node) const
    {
        return {x_.unit(map_.x.values[node % columns_]), y_.unit(map_.y.values[node / columns_])};
    }

    const Stretch* parting(UnitPoint p, UnitPoint q) const
    {
        for (const auto& s : stretches_)
            if (s.between(p, q)) return &s;
        return nullptr;
    }

    void spread()
    {
        std::deque<std::size_t> front;
        const auto tell = [&](std::size_t node, Side side) {
            if (nodes_[node] != Side::unknown || !linearly_stable(map_.region[node])) return;
            nodes_[node] = side;
            front.push_back(node);
        };
        std::vector<bool> crossed(2 * nodes_.size());
        for (std::size_t node = 0; node < nodes_.size(); ++node)
            for (const bool up : {false, true}) {
                const auto other = neighbour(node, up);
                if (!other) continue;
                const UnitPoint p = place(node), q = place(*other);
                const Stretch* s = parting(p, q);
                if (!s) continue;
                crossed[2 * node + up] = true;
                tell(node, s->side_of(p));
                tell(*other, s->side_of(q));
            }
        for (; !front.empty(); front.pop_front()) {
            const std::size_t node = front.front();
            const Side side = nodes_[node];
            for (const bool up : {false, true}) {
                if (const auto next = neighbour(node, up); next && !crossed[2 * node + up]) tell(*next, side);
                const std::size_t step = up ? columns_ : 1;
                if (node < step || (!up && node % columns_ == 0) || crossed[2 * (node - step) + up]) continue;
                tell(node - step, side);
            }
        }
    }

    std::optional<std::size_t> neighbour(std::size_t node, bool up) const
    {
        const std::size_t other = up ? node + columns_ : node + 1;
        if (up ? other >= nodes_.size() : other % columns_ == 0) return {};
        return other;
    }

    const StabilityMap& map_;
    UnitAxis x_, y_;
    std::size_t columns_;
    std::vector<Side> nodes_;
    std::vector<Stretch> stretches_;
};

}  // namespace

void mark_bistable(StabilityMap& map, const std::vector<FollowedBoundary>& curves)
{
    if (map.x.values.size() < 2 || map.y.values.size() < 2) return;
    std::vector<std::size_t> bistable;
    bool design = false;
    for (const auto& curve : curves) {
        const bool nonlinear = curve.kind == BoundaryKind::fold || curve.kind == BoundaryKind::outcome;
        if (!nonlinear || ends_in_doubt(curve)) continue;
        const Sides sides(map, curve);
        for (std::size_t node = 0; node < map.region.size(); ++node)
            if (sides.at(node) == Side::cycles) bistable.push_back(node);
        design = design || (map.design.inside && sides.at(map.design.x, map.design.y) == Side::cycles);
    }
    for (const auto node : bistable) map.region[node] = Region::bistable;
    if (design && linearly_stable(map.design.region)) map.design.region = Region::bistable;
    map.disagreement = share_of_area(map, Region::memory_only) + share_of_area(map, Region::velocity_only);
}

const BoundaryPoint* nearest_point(const LocatedRay& ray, double value)
{
    const UnitAxis unit(ray.axis);
    const auto away = [&](const BoundaryPoint& p) { return std::abs(unit.unit(p.value) - unit.unit(value)); };
    const auto nearest = std::min_element(ray.points.begin(), ray.points.end(),
                                          [&](const auto& a, const auto& b) { return away(a) < away(b); });
    return nearest == ray.points.end() ? nullptr : &*nearest;
}

double share_of_area(const StabilityMap& map, Region region)
{
    const auto shares = area_shares(map.x, map.y);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (map.region[i] == region) sum += shares[i];
    return sum;
}

}  // namespace stickslip
