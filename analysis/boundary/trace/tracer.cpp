// One walk along a boundary, from a located point to where it ends or closes.
#include "analysis/boundary/trace/tracer.h"

#include <algorithm>

namespace stickslip {

bool Tracer::closes(const Walk& w, const Located& next) const
{
    if (w.nodes.size() < 4) return false;
    const UnitPoint first = w.nodes.front().p, a = w.nodes.back().p, way = next.p - a;
    const double length = way.length(), along = (first - a).dot(way) / length;
    const bool same_way = (w.nodes[1].p - first).dot(way) > 0;
    return same_way && along > 0 && along <= length && std::abs((first - a).cross(way)) / length < 0.3 * length;
}

bool Tracer::travelled(const Walk& w, UnitPoint p, double near)
{
    for (std::size_t k = 3; k < w.nodes.size(); ++k) {
        // all but the last steps, which lead here
        const UnitPoint a = w.nodes[k - 3].p, way = w.nodes[k - 2].p - a;
        const double length2 = way.dot(way);
        const double share = length2 > 0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0;
        if ((p - a - share * way).length() < near) return true;
    }
    return false;
}

/// A corner or a cusp: looks all around for a way on that keeps the sides to their hands. Where curves cross, two do:
/// the one already taken (`been`) leads round and round.
std::optional<Tracer::Exit> Tracer::beyond_corner(const Walk& w, const Exit& heading, double radius, bool& been)
{
    const UnitPoint here = w.nodes.back().p;
    const UnitPoint back = w.nodes.size() > 1 ? w.nodes[w.nodes.size() - 2].p - here : -1.0 * heading.direction;
    std::optional<Exit> best;
    for (const auto& way_out : exits(here, radius, &back)) {
        if (way_out.left != heading.left) continue;
        if (travelled(w, here + radius * way_out.direction, 0.2 * radius)) {
            been = true;
            continue;
        }
        if (!best || way_out.direction.dot(heading.direction) > best->direction.dot(heading.direction)) best = way_out;
    }
    return best;
}

Tracer::Walk Tracer::walk(const Located& start, Exit heading)
{
    Walk w;
    w.nodes.push_back(start);
    double h = 0.25 * options_.longest_step;
    bool after_corner = false;
    while (static_cast<int>(w.nodes.size()) < options_.point_limit) {
        failure_ = Failure::none;
        const auto next = step(w, heading, h);
        const auto way = next ? next->p - w.nodes.back().p : UnitPoint{};
        const double length = way.length();
        const bool forwards = next && length > 0 && way.dot(heading.direction) > 0;
        const double turned = forwards ? std::abs(angle_between(heading.direction, way)) : 10;
        const bool settled = w.nodes.size() > 1 && !after_corner;
        if (next && next->at_border && length <= options_.shortest_step) {
            w.nodes.push_back(*next);
            w.end = CurveEnd::border;
            return w;
        }
        if (forwards && (turned < options_.turn || (!settled && turned < 1) || h <= 2 * options_.shortest_step)) {
            if (closes(w, *next)) {
                w.end = CurveEnd::closed;
                return w;
            }
            w.nodes.push_back(*next);
            after_corner = false;
            // the direction at the new point is that of the chord, bent on over half its length
            heading.direction = way.normalized().rotated(0.5 * bend(w) * length);
            if (next->at_border) {
                w.end = CurveEnd::border;
                return w;
            }
            if (turned < 0.4 * options_.turn) h = std::min(1.6 * h, options_.longest_step);
            continue;
        }
        if (h > options_.shortest_step) {
            h = std::max(0.4 * h, options_.shortest_step);
            continue;
        }
        const double radius = 4 * options_.shortest_step;
        bool been = false;
        const auto way_on = after_corner ? std::nullopt : beyond_corner(w, heading, radius, been);
        if (!way_on) {
            const bool rim = !(w.nodes.back().p + 2 * radius * heading.direction).inside();
            w.end = been                             ? CurveEnd::closed
                    : failure_ == Failure::undecided ? CurveEnd::undecided
                    : rim                            ? CurveEnd::border
                                                     : CurveEnd::lost;
            return w;
        }
        heading = *way_on;
        h = radius;
        after_corner = true;
    }
    return w;
}

CurvePiece Tracer::piece_through(const Located& start, std::vector<UnitPoint>& path)
{
    CurvePiece piece;
    std::vector<Exit> ways;
    for (double radius = 0.1 * options_.longest_step; ways.empty() && radius > 0.2 * options_.shortest_step;
         radius /= 4)
        ways = exits(start.p, radius);
    Walk forwards, backwards;
    if (ways.empty()) {
        piece.first = piece.last = CurveEnd::lost;
        piece.points.push_back(start.point);
        path.push_back(start.p);
        return piece;
    }
    forwards = walk(start, ways[0]);
    if (forwards.end == CurveEnd::closed) {
        piece.first = piece.last = CurveEnd::closed;
    } else {
        std::size_t other = 0;
        for (std::size_t i = 1; i < ways.size(); ++i)
            if (ways[i].direction.dot(ways[0].direction) < ways[other].direction.dot(ways[0].direction)) other = i;
        if (other > 0)
            backwards = walk(start, ways[other]);
        else
            backwards.end = start.at_border ? CurveEnd::border : forwards.end;
        piece.first = backwards.end;
        piece.last = forwards.end;
    }
    for (std::size_t i = backwards.nodes.size(); i-- > 1;) {
        piece.points.push_back(backwards.nodes[i].point);
        path.push_back(backwards.nodes[i].p);
    }
    for (const auto& node : forwards.nodes) {
        piece.points.push_back(node.point);
        path.push_back(node.p);
    }
    return piece;
}

}  // namespace stickslip
