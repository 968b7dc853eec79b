// One step along a boundary: predicted from the points behind it, corrected across it.
#include "analysis/boundary/trace/foretell.h"
#include "analysis/boundary/trace/tracer.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double safety = 1.5;            ///< of a step that is meant to reach beyond the boundary
constexpr std::size_t points_behind = 7;  ///< from which the next one is foretold

}  // namespace

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
    // the sides keep to their hands along the way, so the side at q says where the boundary lies
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
        // a chord that falls gives the distance, with what it misses once more
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

}  // namespace stickslip
