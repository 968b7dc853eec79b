#include "sweep/study/loop_growth.h"

#include "analysis/joint/commanded_velocity.h"
#include "analysis/joint/loop_side.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Friction holds a joint back by no more than the way of its reference: a loop that is farther off has left it.
constexpr double ways = 10;

double largest(const std::vector<double>& values)
{
    double size = 0;
    for (const double v : values) size = std::max(size, std::abs(v));
    return size;
}

double farthest_off(const LoopRecord& record)
{
    double farthest = 0;
    for (std::size_t i = 0; i < record.position.size(); ++i) {
        const double off = std::abs(record.position[i] - record.reference_position[i]);
        if (off > farthest) farthest = off;
    }
    return farthest;
}

/// At the joint's side of a gear, where verdicts are.
double judged_velocity(const Joint& joint, const LoopRecord& record)
{
    const double fastest = largest(record.reference_velocity) / std::abs(reading_per_joint(joint));
    const double own = joint.control.V0;
    return fastest > 0 ? std::copysign(fastest, is_set(own) ? own : 1) : own;
}

}  // namespace

std::optional<UnstableLoop> unstable_loop(const Joint& joint, const LoopRecord& record)
{
    if (record.position.empty()) return {};
    const auto& reference = record.reference_position;
    const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
    UnstableLoop loop;
    loop.farthest = farthest_off(record);
    // at rest where the reference does not begin, the way to it counts as well
    const double way = *high - *low + std::abs(record.position.front() - reference.front());
    loop.diverges = !(loop.farthest <= ways * way) && way > 0;
    if (record.reason == Reason::none && !loop.diverges) return {};
    Joint there = with_loop_at_joint(joint);
    there.control.V0 = judged_velocity(joint, record);
    there.control.force_rate = not_set;
    loop.velocity = sliding_velocity(there);
    loop.growth = growth_rate(there);
    if (!(loop.growth > 0) && !loop.diverges) return {};
    return loop;
}

}  // namespace stickslip
