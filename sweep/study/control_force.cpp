#include "sweep/study/control_force.h"

#include "analysis/loop/loop_use.h"

#include <cmath>

namespace stickslip {

std::vector<double> control_force(const Joint& joint, const Trajectory& motion)
{
    const auto& c = joint.control;
    const bool known = joint.mechanism.model == Model::single_mass && c.kind == ControlKind::position &&
                       loop_kind(joint) == LoopKind::ideal && std::isfinite(motion.steady_friction) &&
                       motion.commanded_velocity > 0;
    if (!known) return {};
    std::vector<double> force;
    force.reserve(motion.time.size());
    for (std::size_t i = 0; i < motion.time.size(); ++i)
        force.push_back(motion.steady_friction - c.k_p * motion.position[i] -
                        c.k_v * (motion.velocity[i] - motion.commanded_velocity));
    return force;
}

}  // namespace stickslip
