#include "sweep/study/check/boundaries.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/parameters.h"
#include "sweep/study/maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace stickslip {
namespace {

constexpr int rays_per_chart = 9;
constexpr double brackets_allowed = 4;  ///< least tolerance of a point, in widths of its own bracket

std::string theory_of(BoundaryKind kind)
{
    switch (kind) {
        case BoundaryKind::velocity_only:
            return "velocity_only";
        case BoundaryKind::state_variable:
            return "state_variable";
        case BoundaryKind::v_min:
            return "v_min";
        case BoundaryKind::fold:
            return "fold";
        case BoundaryKind::hunting:
            return "hunting";
        case BoundaryKind::outcome:
            break;
    }
    return "outcome";
}

/// What a boundary of a kind is promised to, and what two machines therefore agree on.
double promised(BoundaryKind kind)
{
    return kind == BoundaryKind::fold || kind == BoundaryKind::hunting ? 1e-6
           : kind == BoundaryKind::outcome                             ? 1e-4
                                                                       : 1e-9;
}

/// One ray to be watched for one kind.
struct Watch {
    BoundaryKind kind;
    const Axis* along;
    std::vector<Held> held;
};

std::vector<WatchedBoundary> watch(const Spec& spec, const Watch& ray)
{
    // a tolerance that nobody stated is that of the kind
    const bool stated = spec.check.tolerance != CheckSpec{}.tolerance;
    const double floor = stated ? spec.check.tolerance : promised(ray.kind);
    BoundaryRequest request;
    request.kind = ray.kind;
    request.disturbance = spec.nonlinear.disturbance.disturbance;
    std::vector<WatchedBoundary> watched;
    for (const auto& point : locate_boundaries(joint_at(design_joint(spec), ray.held), *ray.along, request).points) {
        WatchedBoundary w;
        w.theory = theory_of(ray.kind);
        w.axis = ray.along->path;
        w.unit = unit_of(ray.along->quantity, units_of(spec.joint));
        for (const auto& h : ray.held) w.at.emplace_back(h.axis.path, h.value);
        w.number = static_cast<int>(watched.size());
        w.point = point;
        w.tolerance = std::max(floor, brackets_allowed * point.precision());
        watched.push_back(std::move(w));
    }
    return watched;
}

std::vector<BoundaryKind> kinds_of(const Spec& spec)
{
    std::vector<BoundaryKind> kinds{BoundaryKind::velocity_only, BoundaryKind::state_variable};
    if (spec.nonlinear.enabled) kinds.push_back(BoundaryKind::fold);
    if (spec.nonlinear.enabled && is_set(spec.nonlinear.disturbance.disturbance.size))
        kinds.push_back(BoundaryKind::outcome);
    return kinds;
}

}  // namespace

std::vector<WatchedBoundary> watched_boundaries(const Spec& spec, const ParallelFor& parallel)
{
    std::vector<Watch> rays;
    for (const auto& axis : spec.axes)
        if (axis.values.size() > 1)
            for (const auto kind : kinds_of(spec)) rays.push_back({kind, &axis, {}});
    if (const Axis* velocity = axis_of(spec, "control.V0"); velocity && velocity->values.size() > 1)
        rays.push_back({BoundaryKind::v_min, velocity, {}});
    for (const auto& [x, y] : spec.report.charts) {
        const Axis *along = axis_of(spec, x), *across = axis_of(spec, y);
        if (!along || !across || along->values.size() < 2) continue;
        const int last = static_cast<int>(across->values.size()) - 1;
        std::set<int> places;
        for (int i = 0; i < rays_per_chart; ++i) places.insert(i * last / (rays_per_chart - 1));
        for (const int i : places)
            for (const auto kind : kinds_of(spec))
                rays.push_back({kind, along, {{*across, across->values[static_cast<std::size_t>(i)]}}});
    }
    // each ray into its own slot: the order of the baseline does not hang on the number of threads
    std::vector<std::vector<WatchedBoundary>> found(rays.size());
    parallel(rays.size(), [&](std::size_t i) { found[i] = watch(spec, rays[i]); });
    std::vector<WatchedBoundary> watched;
    for (auto& some : found) watched.insert(watched.end(), some.begin(), some.end());
    return watched;
}

}  // namespace stickslip
