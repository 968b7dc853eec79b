#include "analysis/simulation/points.h"
#include "analysis/simulation/attractor/loop_answer.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/lanes/ticked_batch.h"

#include <algorithm>
#include <memory>

namespace stickslip {

void write_nonlinear(const NonlinearVerdict& verdict, PointResult& point)
{
    point.outcome = verdict.outcome;
    point.path = verdict.path;
    point.growth_rate = verdict.growth_rate;
    // sliding that an encoder or its noise disturbs has extrema, but no cycle
    if (verdict.outcome != Outcome::stable_sliding || verdict.region == NonlinearRegion::bistable) {
        point.amplitude = verdict.amplitude;
        point.velocity_min = verdict.velocity_min;
        point.velocity_max = verdict.velocity_max;
        point.period = verdict.period;
        point.stick_fraction = verdict.stick_fraction;
    }
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

std::vector<NonlinearVerdict> real_loop_verdicts(std::span<const Joint* const> joints, const NonlinearOptions& options)
{
    std::vector<NonlinearVerdict> verdicts(joints.size());
    std::vector<const Joint*> together;
    std::vector<std::size_t> place;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (lanes::in_ticked_lanes(*joints[i]))
            together.push_back(joints[i]), place.push_back(i);
        else
            verdicts[i] = nonlinear_verdict(*joints[i], options);
    }
    std::vector<LoopVerdict> found(together.size());
    const auto answered = std::make_unique<bool[]>(together.size());
    lanes::answer_ticked(together, loop_question(options), found, answered.get(), lanes::best_instructions());
    for (std::size_t i = 0; i < together.size(); ++i) {
        auto& verdict = verdicts[place[i]];
        verdict = answered[i] ? verdict_of(found[i], options) : nonlinear_verdict(*together[i], options);
        if (answered[i]) verdict.path = DecisionPath::lanes;
    }
    return verdicts;
}

void nonlinear_points(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points)
{
    if (std::none_of(joints.begin(), joints.end(), takes_ticks)) return ideal_points(joints, options, points);
    std::vector<const Joint*> real;
    std::vector<PointResult*> real_rows;
    std::vector<Joint> ideal;
    std::vector<PointResult> rows;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (takes_ticks(joints[i]))
            real.push_back(&joints[i]), real_rows.push_back(&points[i]);
        else
            ideal.push_back(joints[i]), rows.push_back(points[i]);
    }
    const auto verdicts = real_loop_verdicts(real, options);
    for (std::size_t i = 0; i < real.size(); ++i) write_nonlinear(verdicts[i], *real_rows[i]);
    ideal_points(ideal, options, rows);
    auto next = rows.begin();
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (!takes_ticks(joints[i])) points[i] = *next++;
}

}  // namespace stickslip
