#include "analysis/stability/neighbour_modes.h"

#include <cmath>

#include "analysis/stability/verdict.h"

namespace stickslip {

std::vector<NearMode> near_modes(const Joint& joint)
{
    std::vector<NearMode> near;
    if (joint.neighbour.size == 0) return near;
    Joint alone = joint;
    alone.neighbour.size = 0;
    const double friction = linear_point(alone).omega;
    if (!is_set(friction)) return near;
    for (int i = 0; i < joint.neighbour.size; ++i) {
        const auto& n = joint.neighbour[i];
        const double omega = std::sqrt(n.k_p / n.inertia);
        if (std::abs(omega - friction) <= near_mode * friction) near.push_back({i, omega, friction});
    }
    return near;
}

}  // namespace stickslip
