#include "analysis/boundary/kinds/fold_by_sides.h"

#include "analysis/boundary/kinds/coexistence.h"
#include "analysis/boundary/trace/follow.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/root.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip {
namespace {

/// Relative: how near to a fold a slow passage is distinguished from a cycle. A sampled loop's fold was 6e-5 off
/// against an independent integration of 1200 s.
constexpr double resolved = 1e-4;
static_assert(by_sides_precision > 2 * resolved);
constexpr int edge_steps = 5;  ///< halvings towards joints without a verdict, from either side

/// How narrow a bracket has to be before it is widened by what simulation does not resolve.
double width_of(const BoundaryRequest& request)
{
    return std::max(request.precision - 2 * resolved, resolved / 2);
}

void widen(BoundaryPoint& point, const BoundaryRequest& request)
{
    point.low -= resolved * std::abs(point.low), point.high += resolved * std::abs(point.high);
    point.converged = point.converged && point.precision() <= request.precision;
}

bool has_cycle(double side)
{
    return side >= 0;
}

/// Where the bracket of a point still has a cycle.
std::pair<double, double> end_with_cycle(const CurvePoint& p)
{
    const double end = p.at.direction > 0 ? p.at.high : p.at.low;
    return p.along_y ? std::pair{p.x, end} : std::pair{end, p.y};
}

/// Of a boundary of cycles only what is a fold: where sliding is stable on its side with the cycle, too.
void keep_folds(const Joint& joint, FollowedBoundary& boundary, const BoundaryRequest& request)
{
    std::vector<Joint> joints;
    for (const auto& piece : boundary.pieces)
        for (const auto& p : piece.points) {
            const auto [x, y] = end_with_cycle(p);
            joints.push_back(joint);
            number_at(joints.back(), boundary.x.path) = x;
            number_at(joints.back(), boundary.y.path) = y;
        }
    const auto sides = coexistence(joints, request.parallel);
    boundary.evaluations += static_cast<int>(joints.size());
    std::vector<CurvePiece> kept;
    std::size_t i = 0;
    for (const auto& piece : boundary.pieces) {
        bool open = false;
        for (const auto& p : piece.points) {
            const bool fold = sides[i++] == 0;
            if (fold && !open) kept.push_back({{}, &p == &piece.points.front() ? piece.first : CurveEnd::vanished});
            if (fold) {
                kept.back().points.push_back(p);
                widen(kept.back().points.back().at, request);
            }
            if (!fold && open) kept.back().last = CurveEnd::vanished;
            open = fold;
        }
        if (open) kept.back().last = piece.last;
    }
    boundary.pieces = std::move(kept);
}

}  // namespace

FoldBySides::FoldBySides(const Joint& joint, const Axis& axis, const BoundaryRequest& request)
    : joint_(joint), axis_(axis), request_(request), unit_(axis)
{
}

std::vector<SideAt> FoldBySides::scan(int count)
{
    std::vector<SideAt> nodes;
    std::vector<Joint> joints;
    for (int i = 0; i <= count; ++i) {
        nodes.push_back({unit_.value(static_cast<double>(i) / count)});
        joints.push_back(joint_);
        number_at(joints.back(), axis_.path) = nodes.back().value;
    }
    const auto sides = coexistence(joints, request_.parallel);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].side = sides[i];
    evaluations_ += static_cast<int>(nodes.size());
    return nodes;
}

SideAt FoldBySides::at(double value)
{
    Joint joint = joint_;
    number_at(joint, axis_.path) = value;
    ++evaluations_;
    return {value, coexistence({joint}, request_.parallel).front()};
}

std::optional<BoundaryPoint> FoldBySides::between(SideAt cycle, SideAt none)
{
    double open = missing;  // a value without a verdict
    const auto sign = [&](double value) {
        const SideAt here = at(value);
        if (has_cycle(here.side)) cycle = here;
        if (here.side < 0) none = here;
        if (std::isnan(here.side)) open = value;
        return std::isnan(here.side) ? missing : has_cycle(here.side) ? 1.0 : -1.0;
    };
    const int before = evaluations_;
    const auto root = bracketed_root(sign, cycle.value, 1, none.value, -1, width_of(request_), unit_.least_width());
    if (std::isfinite(open)) {  // the bracket narrows to where there are no verdicts
        const double middle = open;
        for (double inner = middle, i = 0; i < edge_steps; ++i) {
            const double value = 0.5 * (cycle.value + inner);
            if (!(sign(value) > 0)) inner = value;
        }
        for (double inner = middle, i = 0; i < edge_steps; ++i) {
            const double value = 0.5 * (none.value + inner);
            if (!(sign(value) < 0)) inner = value;
        }
    }
    if (cycle.side != 0) return {};
    BoundaryPoint point;
    point.low = std::min(cycle.value, none.value), point.high = std::max(cycle.value, none.value);
    point.value = 0.5 * (point.low + point.high);
    point.direction = cycle.value < none.value ? -1 : 1;
    point.converged = root.converged;
    point.evaluations = evaluations_ - before;
    point.method = LocationMethod::bisection;
    widen(point, request_);
    return point;
}

std::optional<BoundaryPoint> FoldBySides::beside(double linear_boundary, SideAt stable)
{
    const SideAt near = at(linear_boundary + narrowest_strip * (stable.value - linear_boundary));
    undecided_ += std::isnan(near.side);
    return near.side == 0 ? between(near, stable) : std::nullopt;
}

FollowedBoundary follow_folds_by_sides(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request)
{
    Sides sides;
    sides.continuous = false;
    sides.precision = width_of(request);
    sides.many = [&](const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& values) {
        std::vector<Joint> joints(u.size(), joint);
        for (std::size_t i = 0; i < u.size(); ++i)
            number_at(joints[i], x.path) = u[i], number_at(joints[i], y.path) = v[i];
        values = cycle_sides(joints, request.parallel);
    };
    sides.at = [&](double u, double v) {
        std::vector<double> value;
        sides.many({u}, {v}, value);
        return value.front();
    };
    auto boundary = follow_boundary(sides, x, y, request.following);
    boundary.kind = BoundaryKind::fold;
    boundary.by_sides = true;
    keep_folds(joint, boundary, request);
    return boundary;
}

}  // namespace stickslip
