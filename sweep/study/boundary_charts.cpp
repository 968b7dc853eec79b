#include "sweep/study/boundary_charts.h"

#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/beyond_curves.h"
#include "sweep/study/maps.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int map_nodes = 81;  ///< along each axis

bool same_axes(const FollowedBoundary& a, const FollowedBoundary& b)
{
    return a.x.path == b.x.path && a.y.path == b.y.path && a.x.values == b.x.values && a.y.values == b.y.values;
}

/// Whether small disturbances decay all the way from one value of a parameter to another.
bool stable_between(Joint joint, const Axis& axis, double from, double to)
{
    constexpr int samples = 33;
    const auto number = number_at(joint, axis.path);
    for (int i = 0; i < samples; ++i) {
        number = from + (to - from) * i / samples;
        if (!(linear_point(joint).spectral_abscissa < 0)) return false;
    }
    return true;
}

}  // namespace

StabilityMap stability_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel)
{
    x.values = spaced(x.values.front(), x.values.back(), map_nodes, x.log);
    y.values = spaced(y.values.front(), y.values.back(), map_nodes, y.log);
    StabilityMap map;
    map.units = units_of(design);
    map.abscissa.resize(x.values.size() * y.values.size());
    map.region.resize(map.abscissa.size());
    parallel(y.values.size(), [&](std::size_t j) {
        Joint joint = design;
        const auto u = number_at(joint, x.path), v = number_at(joint, y.path);
        for (std::size_t i = 0; i < x.values.size(); ++i) {
            u = x.values[i], v = y.values[j];
            const auto row = linear_point(joint);
            map.abscissa[j * x.values.size() + i] = row.spectral_abscissa;
            map.region[j * x.values.size() + i] = row.region;
        }
    });
    map.design = place_over(design, x, y);
    const auto row = linear_point(design);
    map.design.region = row.region;
    map.design.spectral_abscissa = row.spectral_abscissa;
    map.has_design = true;
    map.x = std::move(x), map.y = std::move(y);
    map.disagreement = share_of_area(map, Region::memory_only) + share_of_area(map, Region::velocity_only);
    map.undecided = share_of_area(map, Region::undecided);
    return map;
}

std::vector<BoundaryChart> boundary_charts(const Joint& design, const std::vector<FollowedBoundary>& curves,
                                           const ParallelFor& parallel)
{
    std::vector<BoundaryChart> charts;
    for (const auto& c : curves) {
        if (charts.empty() || !same_axes(charts.back().curves.front(), c)) charts.emplace_back();
        charts.back().curves.push_back(c);
    }
    for (auto& chart : charts) {
        const Axis &x = chart.curves.front().x, &y = chart.curves.front().y;
        const auto hunting =
            std::ranges::count_if(chart.curves, [](const auto& c) { return c.kind == BoundaryKind::hunting; });
        if (hunting < std::ssize(chart.curves)) {
            chart.sliding = stability_under(design, x, y, parallel);
            mark_bistable(*chart.sliding, chart.curves);
        }
        if (hunting > 0) chart.at_rest = hunting_field(design, x, y, parallel);
    }
    return charts;
}

bool beyond_ray(const Joint& design, const LocatedRay& ray)
{
    if (ray.kind != BoundaryKind::fold && ray.kind != BoundaryKind::outcome) return false;
    Joint joint = design;
    const double own = number_at(joint, ray.axis.path);
    const auto* p = nearest_point(ray, own);
    if (!p) {  // a cycle or the stated disturbance's end in stick-slip all along the axis, the design included
        const bool on_axis = own >= ray.axis.values.front() && own <= ray.axis.values.back();
        return on_axis && ray.stable_share == 0 && ray.undecided == 0 && linear_point(joint).spectral_abscissa < 0;
    }
    if (p->direction == 0) return false;
    const bool cycles = (own > p->value) == (p->direction > 0);
    return cycles && stable_between(joint, ray.axis, own, p->value);
}

}  // namespace stickslip
