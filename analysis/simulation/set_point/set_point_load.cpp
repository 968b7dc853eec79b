#include "analysis/simulation/set_point/set_point_load.h"

#include "analysis/joint/drive.h"
#include "analysis/loop/felt.h"

#include <cmath>

namespace stickslip {
namespace {

/// Of the link where the encoder reads 0.
double place_of(const Joint& joint)
{
    return -joint.sensor.position_offset / joint.sensor.position_scale;
}

}  // namespace

RestingPull pull_at(const Joint& joint, double x, double per_signal)
{
    Load steady = joint.load;
    steady.disturbance = {};
    const double contact = joint.control.contact_stiffness * (place_of(joint) + x);
    const double pull = load_force(steady, place_of(joint) + x, 0.0) - contact -
                        joint.friction.normal_load * joint.friction.asymmetry.coulomb;
    // the controller knows the reference, which is the set point wherever the joint is
    const auto& l = joint.load;
    const bool fed = joint.control.feed_forward.gravity;
    return {pull, pull + (fed ? per_signal * l.gravity_amplitude * std::sin(l.gravity_phase) : 0)};
}

double gravity_stiffness(const Joint& joint)
{
    return joint.load.gravity_amplitude * std::cos(place_of(joint) + joint.load.gravity_phase);
}

bool load_bends(const Joint& joint)
{
    const auto& l = joint.load;
    return noticed(joint, l.gravity_amplitude) || noticed(joint, l.cogging.steepest()) ||
           noticed(joint, joint.control.contact_stiffness);
}

}  // namespace stickslip
