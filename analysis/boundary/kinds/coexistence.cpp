#include "analysis/boundary/kinds/coexistence.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/parameters.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"

namespace stickslip {
namespace {

constexpr std::size_t batch = 64;  ///< joints that lanes follow side by side

}  // namespace

std::vector<double> coexistence(const std::vector<Joint>& joints, const ParallelFor& parallel)
{
    std::vector<PointResult> points(joints.size());
    const NonlinearOptions options;
    parallel((joints.size() + batch - 1) / batch, [&](std::size_t b) {
        const std::size_t from = b * batch, count = std::min(batch, joints.size() - from);
        for (std::size_t i = from; i < from + count; ++i) points[i] = linear_point(joints[i]);
        nonlinear_points(std::span(joints).subspan(from, count), options, std::span(points).subspan(from, count));
    });
    std::vector<double> sides;
    for (const auto& p : points) {
        // where the start from near rest is undecided, a reason stands beside the outcome of the small disturbance
        const bool decided = p.outcome != Outcome::undecided && p.outcome != Outcome::solver_failure &&
                             p.outcome != Outcome::not_asked && p.outcome != Outcome::linear_only &&
                             p.reason == Reason::none;
        sides.push_back(!decided                               ? missing
                        : p.region == Region::bistable         ? 0
                        : p.outcome == Outcome::stable_sliding ? -1
                                                               : 1);
    }
    return sides;
}

std::vector<double> cycle_sides(const std::vector<Joint>& joints, const ParallelFor& parallel)
{
    auto sides = coexistence(joints, parallel);
    for (double& side : sides)
        if (side == 0) side = 1;
    return sides;
}

bool has_smooth_orbits(const Joint& joint, const std::vector<Axis>& axes)
{
    const auto smooth = [](const Joint& j) {
        if (has_real_loop(j) || j.mechanism.model != Model::single_mass) return false;
        const auto [flow, reason] = sliding_flow(j);
        return reason == Reason::none && flow.states > 0;
    };
    // an end of an axis may bring a delay, a period or a limit into a loop that has none
    for (const bool last : {false, true}) {
        Joint corner = joint;
        for (const auto& axis : axes) number_at(corner, axis.path) = last ? axis.values.back() : axis.values.front();
        if (!smooth(corner)) return false;
    }
    return true;
}

}  // namespace stickslip
