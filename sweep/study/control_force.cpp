#include "sweep/study/control_force.h"

#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
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

}  // namespace

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

}  // namespace stickslip
