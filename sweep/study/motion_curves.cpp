#include "sweep/study/motion_curves.h"

#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_loop.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// The loop is the ideal one for motions of any size within its limits, and nothing but it moves the joint.
bool is_linear(const Joint& joint)
{
    const auto use = loop_use(joint);
    return use.kind == LoopKind::ideal &&
           std::all_of(use.not_used.begin(), use.not_used.end(), [](const UnusedTerm& term) {
               return !term.matters && (term.why == WhyNot::small_signal || term.why == WhyNot::reference_only);
           });
}

std::vector<double> control_force(const Joint& joint, const Trajectory& motion)
{
    const auto& c = joint.control;
    const bool known = joint.mechanism.model == Model::single_mass && c.kind == ControlKind::position &&
                       motion.commanded_velocity != 0 && std::isfinite(motion.commanded_velocity) && is_linear(joint);
    if (!known) return {};
    const auto [k_p, k_v, k_i] = gains_of(c);
    const double steady = steady_effort(joint, motion.commanded_velocity);
    const double most = std::min(c.effort_limit, joint.actuator.limit);
    std::vector<double> force;
    force.reserve(motion.time.size());
    for (std::size_t i = 0; i < motion.time.size(); ++i)
        force.push_back(std::clamp(
            steady - k_p * motion.position[i] - k_v * (motion.velocity[i] - motion.commanded_velocity), -most, most));
    return force;
}

/// On the link, whose velocity is the motion's.
Samples steady_friction(const Joint& joint, const Trajectory& motion, std::size_t settled_from)
{
    constexpr int points = 240;
    constexpr double still = 1e-3;  // per commanded velocity: a motion that has settled has no loop
    const auto [least, high] =
        std::minmax_element(motion.velocity.begin() + static_cast<std::ptrdiff_t>(settled_from), motion.velocity.end());
    if (*high - *least <= still * std::abs(motion.commanded_velocity)) return {};
    const Chain chain = chain_of(joint);
    const auto& friction = *chain.body[chain.bodies - 1].friction;
    const double low = info(friction.law).needs_motion ? std::max(*least, 1e-3 * *high) : *least;
    Samples curve;
    for (int i = 0; i <= points; ++i) {
        const double V = low + (*high - low) * i / points;
        if (V == 0) continue;
        curve.x.push_back(V);
        curve.y.push_back(steady_force(friction, V));
    }
    return curve;
}

}  // namespace

MotionCurves motion_curves(const Joint& joint, const Trajectory& motion)
{
    if (motion.time.empty()) return {};
    const auto& time = motion.time;
    const auto from =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), 2 * time.back() / 3) - time.begin());
    return {from, control_force(joint, motion), steady_friction(joint, motion, from)};
}

}  // namespace stickslip
