#include "analysis/simulation/points.h"
#include "analysis/simulation/sampled/loop_verdict.h"

#include <algorithm>
#include "analysis/simulation/lanes/batch.h"

namespace stickslip {

void write_nonlinear(const NonlinearVerdict& verdict, PointResult& point)
{
    point.outcome = verdict.outcome;
    point.path = verdict.path;
    point.growth_rate = verdict.growth_rate;
    point.amplitude = verdict.amplitude;
    point.velocity_min = verdict.velocity_min;
    point.velocity_max = verdict.velocity_max;
    point.period = verdict.period;
    point.stick_fraction = verdict.stick_fraction;
    point.overshoot = verdict.overshoot;
    if (verdict.region == NonlinearRegion::bistable) point.region = Region::bistable;
    if (point.reason == Reason::none) point.reason = verdict.reason;
}

namespace {

/// Lanes step the ideal loop; the others are followed one by one.
void ideal_points(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points)
{
    std::vector<std::size_t> left_over;
    lanes::answer(joints, options, points, left_over);
    for (const auto i : left_over) {
        // lanes count from steady sliding and measure small growth better, even where they do not find the end
        const double measured = points[i].growth_rate;
        write_nonlinear(nonlinear_verdict(joints[i], options), points[i]);
        if (is_set(measured)) points[i].growth_rate = measured;
    }
}

}  // namespace

void nonlinear_points(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points)
{
    if (std::none_of(joints.begin(), joints.end(), has_real_loop)) return ideal_points(joints, options, points);
    std::vector<Joint> ideal;
    std::vector<PointResult> rows;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (has_real_loop(joints[i]))
            write_nonlinear(nonlinear_verdict(joints[i], options), points[i]);
        else
            ideal.push_back(joints[i]), rows.push_back(points[i]);
    }
    ideal_points(ideal, options, rows);
    auto next = rows.begin();
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (!has_real_loop(joints[i])) points[i] = *next++;
}

}  // namespace stickslip
