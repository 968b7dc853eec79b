#include "sweep/study/plan.h"

#include "analysis/results/cannot_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

gap::PlannedMotion on_period(const std::vector<double>& time, const std::vector<double>& position, double period)
{
    gap::PlannedMotion motion;
    const auto count = static_cast<std::size_t>((time.back() - time.front()) / period + 1e-9) + 1;
    std::size_t row = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = time.front() + static_cast<double>(k) * period;
        while (row + 2 < time.size() && time[row + 1] < t) ++row;
        const double s = std::clamp((t - time[row]) / (time[row + 1] - time[row]), 0.0, 1.0);
        motion.time.push_back(static_cast<double>(k) * period);
        motion.position.push_back(std::lerp(position[row], position[row + 1], s));
    }
    return motion;
}

std::size_t shown(const gap::Power& power)
{
    return static_cast<std::size_t>(
        std::count_if(power.effects.begin(), power.effects.end(), [](const auto& e) { return is_set(e.least_size); }));
}

/// More effects, else fewer pairs that look alike.
bool tells_more(const gap::Power& one, const gap::Power& than)
{
    if (shown(one) != shown(than)) return shown(one) > shown(than);
    return one.inseparable.size() < than.inseparable.size();
}

}  // namespace

PlanAnswer plan(const Joint& joint, const std::vector<double>& time, const std::vector<double>& position,
                bool look_further, const ParallelFor& parallel)
{
    if (!is_set(joint.control.period)) throw CannotAnswer(CannotAnswer::Why::no_period, "");
    if (time.size() < 2) throw CannotAnswer(CannotAnswer::Why::few_rows, "");
    const auto motion = on_period(time, position, joint.control.period);
    PlanAnswer answer;
    answer.power = gap::power_of(joint, motion, parallel);
    if (!look_further) return answer;
    answer.of_better = answer.power;
    const double duration = std::min(20.0, motion.time.back());
    for (auto& other : gap::safe_motions(gap::reach_of(motion.time, motion.position), duration, joint.control.period)) {
        const auto power = gap::power_of(joint, {other.time, other.position}, parallel);
        if (!tells_more(power, answer.of_better)) continue;
        answer.of_better = power;
        answer.better = std::move(other);
    }
    return answer;
}

}  // namespace stickslip
