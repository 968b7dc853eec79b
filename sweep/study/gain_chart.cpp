#include "sweep/study/gain_chart.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/stability/comparison.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"
#include "sweep/study/samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Points along each axis, and lines on which boundaries are looked for; where dead time leaves roots without end each
/// point costs a search.
struct Fineness {
    int columns, rows, mesh;
};
constexpr Fineness fine{81, 61, 48}, coarse{33, 25, 16};

constexpr double beside = 3;  ///< how far beyond the ends of windows a chart reaches, as a factor

/// Takes finite ends of windows into a range.
void widen(Interval& range, const std::vector<Interval>& windows)
{
    for (const auto& i : windows)
        for (const double end : {i.low, i.high})
            if (end > 0 && std::isfinite(end)) range = {std::min(range.low, end), std::max(range.high, end)};
}

Interval k_p_range(const Joint& joint, const StableGains& own, const StableGains& ideal)
{
    Interval range{joint.control.k_p, joint.control.k_p};
    widen(range, own.stable);
    widen(range, ideal.stable);
    return {range.low / beside, range.high * beside};
}

/// From 0 to beyond the last end, or beyond what the velocity-only model requires.
double k_v_end(const Joint& joint)
{
    Interval range{joint.control.k_v, joint.control.k_v};
    for (const auto theory : {Theory::velocity_only, Theory::state_variable})
        if (const auto windows = stable_velocity_gains(joint, theory)) widen(range, *windows);
    return 1.3 * range.high;
}

bool has_gains_to_turn(const Joint& joint)
{
    return joint.control.kind == ControlKind::position && joint.control.structure != Structure::cascade &&
           joint.control.k_p > 0 && steady_sliding(joint).reason == Reason::none;
}

const Fineness& fineness_of(const Joint& joint)
{
    return loop_kind(joint) == LoopKind::continuous ? coarse : fine;
}

Axis k_p_axis(const Interval& range, int points)
{
    return {"control.k_p",           "k_{p}", "position gain",
            Quantity::position_gain, true,    log_steps(range.low, range.high, points)};
}

GainChart judged(const Joint& joint, const Axis& k_p, const Axis& k_v, int mesh)
{
    GainChart chart;
    auto& slice = chart.slice;
    slice.x = k_p, slice.y = k_v;
    const std::size_t columns = slice.x.values.size();
    slice.abscissa.resize(columns * slice.y.values.size());
    slice.region.resize(slice.abscissa.size());
    tbb::parallel_for(std::size_t{0}, slice.y.values.size(), [&](std::size_t row) {
        Joint there = joint;
        there.control.k_v = slice.y.values[row];
        for (std::size_t i = 0; i < columns; ++i) {
            there.control.k_p = slice.x.values[i];
            const auto point = linear_point(there);
            slice.abscissa[row * columns + i] = point.spectral_abscissa;
            slice.region[row * columns + i] = point.region;
        }
    });
    chart.answer.curves = chart_boundaries(joint, slice.x, slice.y, mesh);
    chart.answer.precision = linear_precision;
    chart.answer.mesh = mesh;
    chart.answer.design = design_point(joint, slice);
    return chart;
}

}  // namespace

std::optional<GainChart> gain_chart_over(const Joint& joint, const Interval& k_p, const Interval& k_v)
{
    if (!has_gains_to_turn(joint) || !(k_p.low > 0) || !(k_v.low > 0)) return std::nullopt;
    const auto& size = fineness_of(joint);
    return judged(joint, k_p_axis(k_p, size.columns),
                  {"control.k_v", "k_{v}", "velocity gain", Quantity::velocity_gain, true,
                   log_steps(k_v.low, k_v.high, size.rows)},
                  size.mesh);
}

std::optional<GainChart> gain_chart(const Joint& joint)
{
    if (left_out_by_ideal(joint).used.empty() || !has_gains_to_turn(joint)) return std::nullopt;
    const auto own = stable_gains(joint), ideal = stable_gains(with_ideal_loop(joint));
    if (!own.known) return std::nullopt;
    const auto k_p = k_p_range(joint, own, ideal);
    const double top = k_v_end(joint);
    if (!std::isfinite(top) || !(top > 0)) return std::nullopt;
    const auto& size = fineness_of(joint);
    Axis k_v{"control.k_v", "k_{v}", "velocity gain", Quantity::velocity_gain, false, {}};
    for (int i = 0; i < size.rows; ++i) k_v.values.push_back(top * i / (size.rows - 1));
    return judged(joint, k_p_axis(k_p, size.columns), k_v, size.mesh);
}

}  // namespace stickslip
