#include "sweep/study/evaluate_points.h"

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

/// Lanes follow whatever they are given, and neighbours on the map answer for what lies between them.
PointResult no_such_joint()
{
    PointResult row;
    row.reason = Reason::impossible;
    row.outcome = Outcome::undecided;
    return row;
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
    EvaluateChunk evaluate = [options = nonlinear_options(spec)](PointCursor& cursor, std::span<PointResult> rows) {
        evaluate_nonlinear(cursor, rows, options);
    };
    if (is_dense(spec, axes)) evaluate = dense_evaluator(nonlinear_options(spec), spec.interpolation, axes);
    return [evaluate](PointCursor& cursor, std::span<PointResult> rows) {
        evaluate(cursor, rows);
        for (auto& row : rows)
            if (row.reason == Reason::impossible) row = no_such_joint();
    };
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
    if (spec.enabled && takes_ticks(joint)) return real_loop_point_cost;
    const bool in_lanes = lanes::scaled(joint) || lanes::stribeck_scaled(joint) || lanes::watched_scaled(joint);
    if (spec.enabled && !in_lanes) return lone_point_cost;
    return spec.enabled ? nonlinear_point_cost : linear_point_cost;
}

}  // namespace stickslip
