// In one file: one question, answered by the kind of its boundary.
#include "analysis/boundary/kinds/boundary.h"

#include "analysis/base/require_valid.h"
#include "analysis/boundary/kinds/coexistence.h"
#include "analysis/boundary/kinds/fold.h"
#include "analysis/boundary/kinds/fold_by_sides.h"
#include "analysis/boundary/kinds/linear_side.h"
#include "analysis/boundary/kinds/outcome.h"
#include "analysis/boundary/kinds/ray.h"
#include "analysis/boundary/trace/chart.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/joint/rules.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace stickslip {
namespace {

/// The request as it stands after its defaults.
BoundaryRequest completed(BoundaryRequest request, const Joint& joint, const std::vector<Axis>& axes)
{
    require_valid(request);
    if (!is_set(request.precision)) {
        const bool by_sides = request.kind == BoundaryKind::fold && !has_smooth_orbits(joint, axes);
        request.precision = by_sides ? by_sides_precision : default_precision(request.kind);
    }
    if (request.following.guard == 0) request.following.guard = default_guard(is_linear(request.kind));
    if (!request.parallel)
        request.parallel = [](std::size_t n, const std::function<void(std::size_t)>& task) {
            for (std::size_t i = 0; i < n; ++i) task(i);
        };
    return request;
}

/// The default, finer where a linear theory covers so many decades that its intervals would become wide.
int scan_of(BoundaryKind kind, const Axis& axis)
{
    constexpr double intervals_per_decade = 8;
    const UnitAxis unit(axis);
    const double decades = unit.log ? unit.span() / std::log(10.0) : 0;
    const int enough = is_linear(kind) ? static_cast<int>(std::ceil(intervals_per_decade * decades)) : 0;
    return std::max(default_scan(kind), enough);
}

constexpr double followed_by_sides = 1e-6;  ///< precision of linear curves that counts of roots bracket

/// The least velocity is looked for with the velocity commanded as such.
Joint prepared(Joint joint, BoundaryKind kind)
{
    if (kind == BoundaryKind::v_min) joint.control.force_rate = not_set;
    return joint;
}

/// A joint of its own at a place of the chart: the walk to a number by its path costs more than a linear verdict.
class JointOnChart {
  public:
    JointOnChart(const Joint& joint, const Axis& x, const Axis& y)
        : joint_(joint), x_(number_at(joint_, x.path)), y_(number_at(joint_, y.path))
    {
    }
    JointOnChart(const JointOnChart&) = delete;  // the numbers point into the joint

    double side(double x, double y, const BoundaryRequest& request)
    {
        x_ = x, y_ = y;
        return side_of(joint_, request);
    }

  private:
    Joint joint_;
    JointNumber x_, y_;
};

Sides sides_over(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request)
{
    constexpr std::size_t together = 16;
    Sides sides;
    sides.continuous = is_linear(request.kind) && !is_told_by_count(joint, request.kind);
    sides.precision = request.precision;
    sides.at = [&, own = std::make_shared<JointOnChart>(joint, x, y)](double u, double v) {
        return own->side(u, v, request);
    };
    sides.many = [&](const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& values) {
        if (request.kind == BoundaryKind::outcome) {
            std::vector<Joint> joints(u.size(), joint);
            for (std::size_t i = 0; i < u.size(); ++i)
                number_at(joints[i], x.path) = u[i], number_at(joints[i], y.path) = v[i];
            values = outcome_sides(joints, request.disturbance, request.parallel);
            return;
        }
        request.parallel((u.size() + together - 1) / together, [&](std::size_t block) {
            JointOnChart own(joint, x, y);
            for (std::size_t i = block * together; i < std::min(u.size(), (block + 1) * together); ++i)
                values[i] = own.side(u[i], v[i], request);
        });
    };
    return sides;
}

/// Whether sliding turns stable there away from rest, whichever way the joint moves.
bool stable_beyond(double velocity, int direction)
{
    return velocity * direction <= 0;
}

/// Of the ends of stable velocities the one from which on every velocity slides, for each direction of motion.
void keep_least(std::vector<BoundaryPoint>& points)
{
    const auto beyond = [&](const BoundaryPoint& p) {
        return std::any_of(points.begin(), points.end(), [&](const BoundaryPoint& q) {
            return std::signbit(q.value) == std::signbit(p.value) && std::abs(q.value) > std::abs(p.value);
        });
    };
    std::vector<BoundaryPoint> kept;
    for (const auto& p : points)
        if (stable_beyond(p.value, p.direction) && !beyond(p)) kept.push_back(p);
    points = std::move(kept);
}

/// Of a curve over (x, V_0) only what is that velocity for its x: turning stable away from rest, and no other change
/// further away.
void keep_least(FollowedBoundary& boundary)
{
    const auto changes_beyond = [&](const CurvePoint& p) {
        for (const auto& piece : boundary.pieces)
            for (std::size_t i = 1; i < piece.points.size(); ++i) {
                const auto &a = piece.points[i - 1], &b = piece.points[i];
                if ((a.x < p.x) == (b.x < p.x)) continue;
                const double share = (p.x - a.x) / (b.x - a.x), y = a.y + share * (b.y - a.y);
                const bool further = std::signbit(y) == std::signbit(p.y) && std::abs(y) > std::abs(p.y) * (1 + 1e-6);
                if (further && !(&a == &p) && !(&b == &p)) return true;
            }
        return false;
    };
    std::vector<CurvePiece> kept;
    for (const auto& piece : boundary.pieces) {
        bool open = false;
        for (const auto& p : piece.points) {
            const bool least = (!p.along_y || stable_beyond(p.y, p.at.direction)) && !changes_beyond(p);
            if (least && !open) kept.push_back({{}, piece.first, piece.last});
            if (least) kept.back().points.push_back(p);
            open = least;
        }
    }
    boundary.pieces = std::move(kept);
}

/// A motion that takes long is followed by way of the caller's own parallel, so that the caller may end the search
/// there.
double as_one_task(const BoundaryRequest& request, const std::function<double()>& side)
{
    if (!request.parallel) return side();
    double value = missing;
    request.parallel(1, [&](std::size_t) { value = side(); });
    return value;
}

}  // namespace

double hunting_side(const Joint& joint)
{
    if (!obeys_rules(joint)) return missing;
    switch (set_point(joint, quick_set_point).hunting) {
        case Hunting::yes:
            return 1;
        case Hunting::no:
            return -1;
        case Hunting::undecided:
            break;
    }
    return missing;
}

double default_precision(BoundaryKind kind)
{
    return is_linear(kind) ? 1e-10 : kind == BoundaryKind::outcome ? 1e-4 : 1e-6;
}

int default_scan(BoundaryKind kind)
{
    return is_linear(kind) ? 200 : 40;
}

double side_of(const Joint& joint, const BoundaryRequest& request)
{
    // what overflowed has no side
    const auto finite = [](double side) { return std::isfinite(side) ? side : missing; };
    switch (request.kind) {
        case BoundaryKind::velocity_only:
        case BoundaryKind::state_variable:
        case BoundaryKind::v_min:
            return finite(linear_side(joint, request.kind));
        case BoundaryKind::outcome:
            return as_one_task(request, [&] { return outcome_side(joint, request.disturbance); });
        case BoundaryKind::hunting:
            return as_one_task(request, [&] { return hunting_side(joint); });
        case BoundaryKind::fold: {
            const auto alone = [](std::size_t n, const std::function<void(std::size_t)>& task) {
                for (std::size_t i = 0; i < n; ++i) task(i);
            };
            return cycle_sides({joint}, request.parallel ? request.parallel : alone).front();
        }
    }
    return missing;
}

Reason reason_without_side(const Joint& joint, const BoundaryRequest& request)
{
    if (request.kind == BoundaryKind::hunting) return obeys_rules(joint) ? Reason::none : Reason::impossible;
    const Reason steady = linear_verdict(joint).steady.reason;
    if (steady != Reason::none || request.kind != BoundaryKind::outcome) return steady;
    NonlinearOptions options;
    options.disturbance = request.disturbance;
    options.region = false;
    return nonlinear_verdict(joint, options).reason;
}

LocatedRay locate_boundaries(const Joint& given, const Axis& axis, const BoundaryRequest& requested)
{
    const Joint joint = prepared(given, requested.kind);
    Joint probe = joint;
    number_at(probe, axis.path);
    auto request = completed(requested, joint, {axis});
    if (request.scan == 0) request.scan = scan_of(request.kind, axis);
    auto ray =
        request.kind == BoundaryKind::fold ? locate_folds(joint, axis, request) : locate_on_ray(joint, axis, request);
    if (request.kind == BoundaryKind::fold && ray.undecided == ray.nodes) {
        number_at(probe, axis.path) = ray.axis.values.front();
        ray.reason = reason_without_side(probe, request);
    }
    if (request.kind == BoundaryKind::v_min) keep_least(ray.points);
    return ray;
}

FollowedBoundary follow_boundaries(const Joint& given, const Axis& x, const Axis& y, const BoundaryRequest& requested)
{
    const Joint joint = prepared(given, requested.kind);
    Joint probe = joint;
    number_at(probe, x.path), number_at(probe, y.path);
    auto request = completed(requested, joint, {x, y});
    // nearer to it the side of a point is that of a located root
    if (!is_set(requested.precision) && is_told_by_count(joint, request.kind)) request.precision = followed_by_sides;
    if (request.kind == BoundaryKind::v_min && y.path != "control.V0")
        throw std::invalid_argument("the least velocity is followed over control.V0 as the y axis, got " + y.path);
    if (request.kind == BoundaryKind::fold) return follow_folds(joint, x, y, request);
    auto followed = follow_boundary(sides_over(joint, x, y, request), x, y, request.following);
    followed.kind = request.kind;
    if (request.kind == BoundaryKind::v_min) keep_least(followed);
    return followed;
}

}  // namespace stickslip
