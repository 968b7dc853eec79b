#include "analysis/simulation/sampled/unsteady_terms.h"

#include "analysis/simulation/flows/flow.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

bool has_unsteady_terms(const Joint& joint)
{
    if (joint.control.dither.amplitude > 0) return true;
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (has_unsteady_terms(*chain.body[i].friction, joint.load)) return true;
    return false;
}

bool changes_on_the_way(const Joint& joint)
{
    return longest_change(joint) > 0;
}

double longest_change(const Joint& joint)
{
    const auto& load = joint.load;
    const double speed = std::abs(sliding_velocity(joint));
    double longest = joint.control.dither.amplitude > 0 ? turn / joint.control.dither.frequency : 0;
    if (load.gravity_amplitude != 0) longest = std::max(longest, turn / speed);
    if (load.cogging.acts()) longest = std::max(longest, turn / (load.cogging.periods * speed));
    if (load.disturbance.amplitude != 0) longest = std::max(longest, turn / load.disturbance.frequency);
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i) {
        const Friction& friction = *chain.body[i].friction;
        if (friction.ripple.acts())
            longest = std::max(longest, turn / (friction.ripple.periods * chain.body[i].ratio * speed));
        if (friction.drift.change != 0) longest = infinity;
    }
    return longest;
}

Joint without_changes(Joint joint)
{
    joint.load.gravity_amplitude = 0, joint.load.disturbance.amplitude = 0;
    joint.load.cogging = {};
    const auto steady = [](Friction& friction) {
        friction.ripple = {};
        friction.drift = {};
    };
    steady(joint.friction);
    steady(joint.frictions.motor), steady(joint.frictions.transmission), steady(joint.frictions.link);
    return joint;
}

}  // namespace stickslip
