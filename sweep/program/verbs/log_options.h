// Settings of the readers of foreign logs, as options of a verb.
#pragma once
#include "sweep/files/records/joint_log.h"

#include "sweep/program/verbs/command_line.h"

namespace stickslip {

inline void add_log_options(Verb& verb, LogOptions& options)
{
    verb.add_option("--topic", options.topic, "ROS: topic of the joint states");
    verb.add_option("--command", options.command, "ROS: topic of the commands");
    verb.add_option("--time", options.time, "arrays: name of the time");
    verb.add_option("--group", options.group, "HDF5, MATLAB: group or struct that holds the arrays");
    verb.add_option("--episode", options.episode, "LeRobot: number of the episode");
}

}  // namespace stickslip
