#include "sweep/study/evaluate_points.h"

#include "analysis/joint/parameters.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/lanes/stribeck_batch.h"
#include "analysis/simulation/lanes/ticked_batch.h"
#include "analysis/simulation/lanes/watched_batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/dense_chunks.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace stickslip {
namespace {

/// s, of a joint that is followed tick by tick, alone and in lanes.
constexpr double real_loop_point_cost = 0.1, ticked_lanes_point_cost = 3e-3;
constexpr double lone_point_cost = 5e-3;  ///< s, of an ideal loop whose law the lanes do not have

/// Below, cells would be computed whole for the most part, and computing all takes a fraction of a second in lanes.
constexpr double fewest_dense_points = 10'000;

/// A chunk at a time, so that the lanes of the nonlinear evaluation are full.
void evaluate_nonlinear(PointCursor& cursor, std::span<PointResult> rows, const NonlinearOptions& options)
{
    std::vector<Joint> joints;
    joints.reserve(rows.size());
    for (PointResult& row : rows) {
        joints.push_back(cursor.joint());
        row = linear_point(joints.back());
        cursor.advance();
    }
    nonlinear_points(joints, options, rows);
}

}  // namespace

NonlinearOptions nonlinear_options(const NonlinearSpec& spec)
{
    NonlinearOptions options;
    options.disturbance = spec.disturbance.disturbance;
    options.rtol = spec.tolerance;
    return options;
}

bool is_dense(const NonlinearSpec& spec, const std::vector<Axis>& axes)
{
    double points = 1;
    for (const Axis& axis : axes) points *= static_cast<double>(axis.values.size());
    return spec.enabled && spec.interpolation > 0 && points >= fewest_dense_points;
}

EvaluateChunk evaluator(const NonlinearSpec& spec, const std::vector<Axis>& axes)
{
    if (!spec.enabled) return point_by_point([](const Joint& joint) { return linear_point(joint); });
    if (is_dense(spec, axes)) return dense_evaluator(nonlinear_options(spec), spec.interpolation, axes);
    return [options = nonlinear_options(spec)](PointCursor& cursor, std::span<PointResult> rows) {
        evaluate_nonlinear(cursor, rows, options);
    };
}

std::vector<std::string> idle_axes(const Joint& joint, const std::vector<Axis>& axes)
{
    std::vector<std::string> idle;
    for (const auto& axis : axes) {
        const auto varied = [&](double value) {
            Joint other = joint;
            *find_parameter(other, axis.path) = value;
            return other;
        };
        const auto answer = [&](double value) { return linear_point(varied(value)); };
        const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
        const auto first = answer(axis.values.front());
        const auto unchanged = [&](double value) {
            const auto now = answer(value);
            return now.reason == first.reason && same(now.spectral_abscissa, first.spectral_abscissa) &&
                   same(now.k_v_min, first.k_v_min) && same(now.k_cr, first.k_cr);
        };
        // neutral sliding stays neutral with its frequency changed
        const auto spectrum_at = [&](double value) { return linear_verdict(varied(value)).state_variable.eigenvalues; };
        const bool answers = first.reason == Reason::none;  // or else that is told, and no axis is idle
        if (axis.values.size() > 1 && answers && unchanged(axis.values[axis.values.size() / 2]) &&
            unchanged(axis.values.back()) && spectrum_at(axis.values.front()) == spectrum_at(axis.values.back()))
            idle.push_back(axis.path);
    }
    return idle;
}

std::string evaluation_text(const NonlinearSpec& spec, const std::vector<Axis>& axes)
{
    if (!spec.enabled) return "linear";
    const auto& d = spec.disturbance.disturbance;
    return fmt::format("linear and nonlinear, disturbance {} of {}, tolerance {}", static_cast<int>(d.kind), d.size,
                       spec.tolerance) +
           (is_dense(spec, axes) ? fmt::format(", interpolated to {}", spec.interpolation) : "");
}

double seconds_per_point(const NonlinearSpec& spec, const Joint& joint)
{
    if (spec.enabled && lanes::in_ticked_lanes(joint)) return ticked_lanes_point_cost;
    if (spec.enabled && has_real_loop(joint)) return real_loop_point_cost;
    const bool in_lanes = lanes::scaled(joint) || lanes::stribeck_scaled(joint) || lanes::watched_scaled(joint);
    if (spec.enabled && !in_lanes) return lone_point_cost;
    return spec.enabled ? nonlinear_point_cost : linear_point_cost;
}

}  // namespace stickslip
