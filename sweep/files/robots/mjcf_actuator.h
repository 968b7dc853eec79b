// One actuator of MJCF. https://mujoco.readthedocs.io/en/stable/XMLreference.html#actuator-general
// Internal to sweep/files.
#pragma once
#include "sweep/files/robots/mjcf_input.h"

#include <array>
#include <string>

#include "analysis/base/field.h"

namespace stickslip::files {

/// Limits of both signs as a joint of ours has them: one for both directions.
struct MjcfRange {
    double greatest = infinity;
    bool lopsided = false;  ///< one direction has less
};

/// As the <general> actuator that MuJoCo makes of every shortcut: force = gain · command + bias, clamped, times the
/// gear.
struct MjcfActuator {
    std::string kind;  ///< element
    std::string dynamics = "none", gain_type = "fixed", bias_type = "none";
    double time = 1, gain = 1;
    std::array<double, 3> bias{};  ///< constant, by length, by velocity
    double gear = 1, delay = 0, damping = 0, armature = 0;
    MjcfRange command, force;
    MjcfRange activation;  ///< of what a filter makes of the command

    bool filters() const { return dynamics == "filter" || dynamics == "filterexact"; }
    bool is_motor() const { return gain_type == "fixed" && bias_type == "none" && (dynamics == "none" || filters()); }
    /// Of an element that this reader knows; a gear or gain of zero drives nothing.
    bool known = false;
    /// force = gain · (command − length) − k_v · velocity
    bool is_position_servo() const
    {
        return gain_type == "fixed" && bias_type == "affine" && bias[0] == 0 && gain == -bias[1] &&
               (dynamics == "none" || filters() || dynamics == "integrator");
    }
    /// force = gain · (command − velocity)
    bool is_velocity_servo() const
    {
        return gain_type == "fixed" && bias_type == "affine" && bias[0] == 0 && bias[1] == 0 && gain == -bias[2] &&
               (dynamics == "none" || filters());
    }
};

/// Of its two ends.
MjcfRange range_of(const std::vector<double>& values);

/// Its own attributes and those of its classes.
MjcfActuator read_actuator(const MjcfInput& input, const pugi::xml_node& node);

}  // namespace stickslip::files
