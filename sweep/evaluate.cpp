#include "sweep/evaluate.h"

#include "analysis/stability/verdict.h"

#include <fmt/format.h>

#include <vector>

namespace stickslip {
namespace {

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

constexpr double lane_point_cost = 5e-5;  // s: lanes decide most points, CVODE the rest

}  // namespace

NonlinearOptions nonlinear_options(const NonlinearSpec& spec)
{
    NonlinearOptions options;
    options.disturbance = spec.disturbance.disturbance;
    options.rtol = spec.tolerance;
    return options;
}

EvaluateChunk evaluator(const NonlinearSpec& spec)
{
    if (!spec.enabled) return point_by_point([](const Joint& joint) { return linear_point(joint); });
    return [options = nonlinear_options(spec)](PointCursor& cursor, std::span<PointResult> rows) {
        evaluate_nonlinear(cursor, rows, options);
    };
}

std::string evaluation_text(const NonlinearSpec& spec)
{
    if (!spec.enabled) return "linear";
    const auto& d = spec.disturbance.disturbance;
    return fmt::format("linear and nonlinear, disturbance {} of {}, tolerance {}", static_cast<int>(d.kind), d.size,
                       spec.tolerance);
}

double seconds_per_point(const NonlinearSpec& spec)
{
    return spec.enabled ? lane_point_cost : linear_point_cost;
}

}  // namespace stickslip
