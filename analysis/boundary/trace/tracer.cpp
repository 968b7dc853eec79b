// In one file: one walk along a boundary, whose steps (predict, correct, step, close) share its state.
#include "analysis/boundary/trace/tracer.h"

#include "analysis/boundary/trace/foretell.h"
#include "analysis/numerics/root.h"

#include <algorithm>
#include <numbers>

namespace stickslip {
namespace {

constexpr int directions = 16;  ///< looked at around a point for the ways out of it
constexpr int angle_bisections = 4;
constexpr double safety = 1.5;            ///< of a step that is meant to reach beyond the boundary
constexpr std::size_t points_behind = 7;  ///< from which the next one is foretold

bool differ(double a, double b)
{
    return !std::isnan(a) && !std::isnan(b) && (a < 0) != (b < 0);
}

double angle_between(UnitPoint a, UnitPoint b)
{
    return std::atan2(a.cross(b), a.dot(b));
}

}  // namespace

Located Tracer::locate(UnitPoint a, double fa, UnitPoint b, double fb)
{
    const bool along_y = a.u == b.u;
    const UnitAxis& axis = along_y ? y_ : x_;
    const double ua = along_y ? a.v : a.u, ub = along_y ? b.v : b.u;
    const double other = along_y ? x_.value(a.u) : y_.value(a.v);
    const int before = evaluations_;
    const auto f = [&](double value) {
        ++evaluations_;
        const double side = along_y ? sides_.at(other, value) : sides_.at(value, other);
        return sides_.continuous || std::isnan(side) ? side : side < 0 ? -1.0 : 1.0;
    };
    // of two sides that differ in sign only, interpolation is bisection
    if (!sides_.continuous) fa = fa < 0 ? -1 : 1, fb = fb < 0 ? -1 : 1;
    const double va = axis.value(ua), vb = axis.value(ub);
    Bracketed root{};
    if (std::abs(vb - va) <= sides_.precision * std::min(std::abs(va), std::abs(vb)))
        root = {0.5 * (va + vb), std::min(va, vb), std::max(va, vb), 0, true};
    else
        root = bracketed_root(f, va, fa, vb, fb, sides_.precision, axis.least_width());
    Located found;
    const double u = axis.unit(root.value);
    found.p = along_y ? UnitPoint{a.u, u} : UnitPoint{u, a.v};
    found.point.along_y = along_y;
    found.point.x = along_y ? other : root.value;
    found.point.y = along_y ? root.value : other;
    found.point.at = {root.value,
                      root.low,
                      root.high,
                      (fb > fa) == (vb > va) ? 1 : -1,
                      root.converged,
                      evaluations_ - before,
                      sides_.continuous ? LocationMethod::interpolation : LocationMethod::bisection};
    const double bracket = std::abs(ub - ua);
    if (sides_.continuous && bracket > 0) found.slope = std::abs(fb - fa) / bracket;
    return found;
}

std::vector<Tracer::Exit> Tracer::exits(UnitPoint centre, double radius, const UnitPoint* back)
{
    const auto direction = [](double angle) { return UnitPoint{std::cos(angle), std::sin(angle)}; };
    const auto side = [&](double angle) {
        const auto p = centre + radius * direction(angle);
        return p.inside() ? at(p) : std::nan("");
    };
    std::vector<double> angles, around;
    for (int k = 0; k < directions; ++k) angles.push_back(2 * std::numbers::pi * (k + 0.37) / directions);
    if (back) {
        // within a cusp the other branch lies close beside the way back
        const double middle = std::atan2(back->v, back->u) + (back->v < 0 ? 2 * std::numbers::pi : 0);
        for (double offset = 0.002; offset < 0.3; offset *= 1.7)
            for (const double angle : {middle - offset, middle + offset})
                angles.push_back(std::fmod(angle + 2 * std::numbers::pi, 2 * std::numbers::pi));
        std::sort(angles.begin(), angles.end());
    }
    for (const double angle : angles) around.push_back(side(angle));
    std::vector<Exit> found;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const bool wraps = k + 1 == angles.size();
        double a = angles[k], b = wraps ? angles[0] + 2 * std::numbers::pi : angles[k + 1];
        const double fa = around[k], fb = around[wraps ? 0 : k + 1];
        if (!differ(fa, fb)) continue;
        for (int i = 0; i < angle_bisections; ++i) {
            const double middle = 0.5 * (a + b);
            (differ(fa, side(middle)) ? b : a) = middle;
        }
        found.push_back({direction(0.5 * (a + b)), fb < 0 ? -1.0 : 1.0});
    }
    return found;
}

double Tracer::bend(const Walk& w) const
{
    const auto n = w.nodes.size();
    if (n < 3) return 0;
    const auto before = w.nodes[n - 2].p - w.nodes[n - 3].p, last = w.nodes[n - 1].p - w.nodes[n - 2].p;
    const double length = 0.5 * (before.length() + last.length()), angle = angle_between(before, last);
    // beyond a corner the way is straight, as far as is known
    return length > 0 && std::abs(angle) < 1 ? angle / length : 0;
}

std::optional<Located> Tracer::leave(UnitPoint from, UnitPoint to)
{
    const double fa = at(from), fb = at(to);
    if (!differ(fa, fb)) return {};
    auto found = locate(from, fa, to, fb);
    found.at_border = true;
    return found;
}

Tracer::Prediction Tracer::predict(const Walk& w, UnitPoint& q, bool along_y, double h) const
{
    const auto& nodes = w.nodes;
    Prediction p{nodes.size() > 2 ? safety * nodes.back().missed_by : 0.02 * h, 0.5 * h};
    const auto runs = [&](UnitPoint at) { return along_y ? at.u : at.v; };
    // the points behind, as far as they run one way
    const double way = runs(q) - runs(nodes.back().p);
    std::size_t first = nodes.size() - 1;
    while (first > 0 && nodes.size() - first < points_behind &&
           (runs(nodes[first].p) - runs(nodes[first - 1].p)) * way > 0)
        --first;
    std::vector<double> ts, ys, slopes;
    for (std::size_t i = first; i < nodes.size(); ++i) {
        ts.push_back(runs(nodes[i].p));
        ys.push_back(along_y ? nodes[i].p.v : nodes[i].p.u);
        slopes.push_back(nodes[i].point.along_y == along_y ? nodes[i].slope : 0);
    }
    p.slope = slopes.back();
    if (ts.size() < 3) return p;
    const auto place = foretell(ts, ys, runs(q));
    if (std::abs(place.value - (along_y ? q.v : q.u)) < 0.3 * h) {
        (along_y ? q.v : q.u) = std::clamp(place.value, 0.0, 1.0);
        p.first = safety * place.missed_by;
    }
    if (std::find(slopes.begin(), slopes.end(), 0) == slopes.end()) {
        const auto slope = foretell(ts, slopes, runs(q));
        if (!(slope.value > 0)) return p;
        p.slope = slope.value;
        p.doubt = std::min(p.doubt, safety * slope.missed_by / slope.value);
    }
    return p;
}

std::optional<Located> Tracer::correct(UnitPoint q, const Exit& heading, const Prediction& expected)
{
    const UnitPoint t = heading.direction;
    const bool along_y = std::abs(t.u) >= std::abs(t.v);
    const int before = evaluations_;
    double fa = at(q);
    if (std::isnan(fa)) {
        failure_ = Failure::undecided;
        return {};
    }
    // the sides keep to their hands along the way, so the side at q tells where the boundary lies
    const double left = along_y ? (t.u > 0 ? 1 : -1) : (t.v > 0 ? -1 : 1);
    const double outwards = (fa < 0 ? -1.0 : 1.0) == heading.left ? -left : left;
    // next to a value of zero nothing is relatively precise, but a place of the chart is no finer than this
    constexpr double finest = 1e-15;
    const double resolution =
        std::max(finest, along_y ? y_.unit_width(q.v, sides_.precision) : x_.unit_width(q.u, sides_.precision));
    // Newton's step with a known slope, so little further that the other side is reached
    double width = sides_.continuous && expected.slope > 0
                       ? std::abs(fa) / expected.slope * (1 + expected.doubt) + 0.45 * resolution
                       : std::max(expected.first, 0.9 * resolution);
    for (UnitPoint a = q;;) {
        UnitPoint b = q;
        double& moved = along_y ? b.v : b.u;
        const bool last = width >= expected.widest;
        moved = std::clamp(moved + outwards * std::min(width, expected.widest), 0.0, 1.0);
        const double fb = at(b);
        if (std::isnan(fb)) {
            failure_ = Failure::undecided;
            return {};
        }
        if (differ(fa, fb)) {
            auto found = locate(a, fa, b, fb);
            found.missed_by = along_y ? std::abs(found.p.v - q.v) : std::abs(found.p.u - q.u);
            found.point.at.evaluations = evaluations_ - before;
            return found;
        }
        const double here = along_y ? b.v : b.u;
        if (last || here == 0 || here == 1) return {};
        // a chord that falls tells how far it is, with what it misses once more
        const double fall = std::abs(fa) - std::abs(fb);
        const double chord = sides_.continuous && fall > 0 ? 1.5 * width * std::abs(fa) / fall : 0;
        a = b, fa = fb;
        width = std::max(3 * width, chord);
    }
}

std::optional<Located> Tracer::step(const Walk& w, const Exit& heading, double h)
{
    const auto& last = w.nodes.back();
    const UnitPoint from = last.p;
    UnitPoint t = heading.direction.rotated(0.5 * bend(w) * h);
    const bool along_y = std::abs(t.u) >= std::abs(t.v);
    UnitPoint q = from + h * t;
    bool at_border = false;
    // the coordinate that runs ends at the border of the chart
    double& runs = along_y ? q.u : q.v;
    double& other = along_y ? q.v : q.u;
    const double start = along_y ? from.u : from.v;
    if (runs < 0 || runs > 1) {
        const double border = runs < 0 ? 0 : 1, part = (border - start) / (runs - start);
        q = from + part * (q - from);
        runs = border;
        at_border = true;
    }
    const bool beyond = other < 0 || other > 1;
    const double unclamped = other;
    other = std::clamp(other, 0.0, 1.0);
    Prediction expected = predict(w, q, along_y, h);
    expected.first = std::min(expected.first, 0.3 * h);
    const Exit aim{t, heading.left};
    if (auto found = correct(q, aim, expected)) {
        found->at_border = at_border;
        return found;
    }
    if (failure_ == Failure::undecided) return {};
    // perhaps it leaves through the border that lies beside the way
    const double reach = 0.5 * h;
    const double border = unclamped < reach ? 0 : unclamped > 1 - reach ? 1 : -1;
    if (beyond || border >= 0) {
        UnitPoint a = from, b = q;
        (along_y ? a.v : a.u) = (along_y ? b.v : b.u) = border >= 0 ? border : other;
        if (auto found = leave(a, b)) return found;
    }
    return {};
}

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

// In one piece: one step after the other of a trace: predict, correct, judge, adapt.
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
        // a corner or a cusp: look all around for a way on that keeps the sides to their hands
        const double radius = 4 * options_.shortest_step;
        const UnitPoint back =
            w.nodes.size() > 1 ? w.nodes[w.nodes.size() - 2].p - w.nodes.back().p : -1.0 * heading.direction;
        const auto ways = after_corner ? std::vector<Exit>{} : exits(w.nodes.back().p, radius, &back);
        const Exit* best = nullptr;
        bool been = false;
        for (const auto& way_out : ways) {
            if (way_out.left != heading.left) continue;
            // where curves cross, two ways keep the sides; the one already taken leads round and round
            if (travelled(w, w.nodes.back().p + radius * way_out.direction, 0.2 * radius)) {
                been = true;
                continue;
            }
            if (!best || way_out.direction.dot(heading.direction) > best->direction.dot(heading.direction))
                best = &way_out;
        }
        if (!best) {
            const bool rim = !(w.nodes.back().p + 2 * radius * heading.direction).inside();
            w.end = been                             ? CurveEnd::closed
                    : failure_ == Failure::undecided ? CurveEnd::undecided
                    : rim                            ? CurveEnd::border
                                                     : CurveEnd::lost;
            return w;
        }
        heading = *best;
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
