// What acts on the joints of an MJCF tree: actuators, tendons, springs. Internal to sweep/files.
#pragma once
#include "sweep/files/robots/mjcf_input.h"
#include "sweep/study/import/robot.h"

#include <map>
#include <string>
#include <vector>

namespace stickslip::files {

struct MjcfTendon {
    std::vector<int> joints;  ///< of a <fixed> one
    bool spatial = false;     ///< which joints it crosses depends on the pose
};

/// What other elements refer to by name.
struct MjcfNames {
    std::map<std::string, int> bodies, sites;  ///< index of the body, of which a site is a point
    std::map<std::string, MjcfTendon> tendons;
};

/// Index of the joint of this name; -1: none, or one of several degrees of freedom.
int index_of_joint(const Robot& robot, const std::string& name);

/// The element with those of the attributes that it has.
NotTaken not_taken(const MjcfInput& input, NotTakenReason reason, const pugi::xml_node& node,
                   const std::vector<const char*>& attributes);

/// Numbers of an attribute, of which not all are zero.
bool any_number(const MjcfInput& input, const pugi::xml_node& node, const char* name);

/// Tendons by name; those that pull, damp, rub or stop go to what is not taken.
void read_tendons(const MjcfInput& input, MjcfNames& names, Robot& robot);

/// Servos and motors of the joints. Other actuators go to what is not taken.
void read_actuators(const MjcfInput& input, const MjcfNames& names, Robot& robot);

}  // namespace stickslip::files
