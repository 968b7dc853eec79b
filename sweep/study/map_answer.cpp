#include "sweep/study/map_answer.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/map_motions.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace stickslip {
namespace {

constexpr int map_mesh = 96, layer_mesh = 32;  ///< lines along each axis on which boundaries are looked for

/// The axis without its values, as held parameters carry it.
Held held_at(Axis axis, double value)
{
    axis.values.clear();
    return {std::move(axis), value};
}

}  // namespace

DesignPoint design_point(const Joint& design, const Slice& slice)
{
    DesignPoint point = place_over(design, slice.x, slice.y);
    const auto row = linear_point(joint_at(design, slice.held));
    point.region = row.region;
    point.spectral_abscissa = row.spectral_abscissa;
    return point;
}

std::vector<Curve> chart_boundaries(const Joint& joint, const Axis& x, const Axis& y, int mesh)
{
    std::vector<Curve> curves;
    std::vector<Curve::Kind> theories{Curve::Kind::velocity_only, Curve::Kind::state_variable};
    if (!left_out_by_ideal(joint).used.empty()) theories.push_back(Curve::Kind::ideal_loop);
    for (const auto theory : theories) {
        auto curve = locate_over_chart(joint, x, y, theory, mesh);
        if (!curve.x.empty()) curves.push_back(std::move(curve));
    }
    return curves;
}

MapAnswer answer_map(const Joint& design, const Slice& slice)
{
    MapAnswer answer;
    const Joint held = joint_at(design, slice.held);
    answer.curves = chart_boundaries(held, slice.x, slice.y, map_mesh);
    answer.precision = linear_precision;
    answer.mesh = map_mesh;
    answer.layer_curves.resize(slice.layers.size());
    tbb::parallel_for(std::size_t{0}, slice.layers.size(), [&](std::size_t i) {
        const Joint there = joint_at(held, {held_at(slice.depth, slice.layers[i].value)});
        answer.layer_curves[i] = chart_boundaries(there, slice.x, slice.y, layer_mesh);
    });
    answer.design = design_point(design, slice);
    answer.motions = map_motions(design, slice);
    answer.large = large_disturbances(design, slice);
    answer.reduced = compare_reductions(design, slice);
    return answer;
}

GainSurface gain_surface(const Joint& design, const Axis& x, const Axis& y)
{
    GainSurface surface{x, y, {}};
    Joint joint = design;
    const auto u = number_at(joint, x.path), v = number_at(joint, y.path);
    int always = 0, never = 0, windows = 0;
    for (const double b : y.values)
        for (const double a : x.values) {
            u = a, v = b;
            surface.k_cr.push_back(linear_point(joint).k_cr);
            if (std::isfinite(surface.k_cr.back())) continue;
            const auto verdict = linear_verdict(joint);
            if (verdict.steady.reason != Reason::none) continue;
            const auto& stable = verdict.state_variable.stable_intervals;
            if (stable.empty())
                ++never;
            else if (stable.size() == 1 && stable[0].low <= 0 && stable[0].high == infinity)
                ++always;
            else
                ++windows;
        }
    const double points = static_cast<double>(surface.k_cr.size());
    surface.always = always / points, surface.never = never / points, surface.windows = windows / points;
    return surface;
}

}  // namespace stickslip
