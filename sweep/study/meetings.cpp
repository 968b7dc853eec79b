#include "sweep/study/meetings.h"

#include "analysis/simulation/set_point/set_point.h"
#include "sweep/study/beyond_curves.h"
#include "sweep/study/maps.h"

#include <cmath>

namespace stickslip {
namespace {

double drawn(const Axis& axis, double value)
{
    return axis.log ? std::log(value) : value;
}

double undrawn(const Axis& axis, double value)
{
    return axis.log ? std::exp(value) : value;
}

/// Where a curve meets the design's own line along one of its axes, the other number held: the meeting nearest to the
/// design, interpolated between located points; NaN where it does not.
double meeting_along(const FollowedBoundary& c, const Joint& given, bool along_x)
{
    const Axis &along = along_x ? c.x : c.y, &across = along_x ? c.y : c.x;
    Joint joint = given;
    const double own = drawn(along, number_at(joint, along.path)), held = drawn(across, number_at(joint, across.path));
    double found = missing;
    for (const auto& piece : c.pieces)
        for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
            const auto &p = piece.points[i], &q = piece.points[i + 1];
            const double a = drawn(across, along_x ? p.y : p.x) - held, b = drawn(across, along_x ? q.y : q.x) - held;
            if (a * b > 0 || a == b) continue;
            const double from = drawn(along, along_x ? p.x : p.y), to = drawn(along, along_x ? q.x : q.y);
            const double at = from + (to - from) * a / (a - b);
            if (std::isnan(found) || std::abs(at - own) < std::abs(found - own)) found = at;
        }
    return undrawn(along, found);
}

bool hunts(const SetPoint& s)
{
    return s.hunting == Hunting::yes;
}

/// Of the axis: distances behind a boundary of hunting at which the joint is judged. Reason: a located point is known
/// to 1e-10 of itself or so, one interpolated between the points of a curve to the width of a line, about 1e-3. What is
/// undecided at all three stays undecided.
constexpr double steps_behind[] = {1e-4, 1e-3, 1e-2};

/// What the joint does behind a boundary of hunting, seen from the design: at the nearest point where the answer is
/// another one than the design's.
std::optional<SetPoint> behind(const Joint& design, const Meeting& m)
{
    Joint joint = design;
    const auto number = number_at(joint, m.axis.path);
    const double range = drawn(m.axis, m.axis.values.back()) - drawn(m.axis, m.axis.values.front());
    const bool design_hunts = hunts(set_point(design, quick_set_point));
    for (const double step : steps_behind) {
        number = undrawn(m.axis, drawn(m.axis, m.at) + std::copysign(step * range, m.at - m.own));
        const auto there = set_point(joint, quick_set_point);
        if (there.hunting != Hunting::undecided && hunts(there) != design_hunts) return set_point(joint);
    }
    return {};
}

}  // namespace

std::vector<Meeting> meetings_of(const Joint& design, const std::vector<LocatedRay>& rays,
                                 const std::vector<FollowedBoundary>& curves)
{
    std::vector<Meeting> found;
    Joint joint = design;
    for (const auto& ray : rays) {
        const double own = number_at(joint, ray.axis.path);
        if (const auto* p = nearest_point(ray, own)) found.push_back({ray.kind, ray.axis, own, p->value});
    }
    for (const auto& c : curves)
        for (const bool along_x : {true, false}) {
            const Axis& axis = along_x ? c.x : c.y;
            const double at = meeting_along(c, design, along_x);
            if (!std::isnan(at)) found.push_back({c.kind, axis, number_at(joint, axis.path), at, true});
        }
    for (auto& m : found)
        if (m.kind == BoundaryKind::hunting) m.beyond = behind(design, m);
    return found;
}

}  // namespace stickslip
