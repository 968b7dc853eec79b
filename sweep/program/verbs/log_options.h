// Settings of the readers of foreign logs, as options of a verb.
#pragma once
#include "sweep/files/records/joint_log.h"

#include <CLI/CLI.hpp>

namespace stickslip {

inline void add_log_options(CLI::App& verb, LogOptions& options)
{
    verb.add_option("--topic", options.topic, "ROS: topic of the joint states");
    verb.add_option("--command", options.command, "ROS: topic of the commands");
    verb.add_option("--time", options.time, "arrays: which one is the time");
    verb.add_option("--episode", options.episode, "LeRobot: which episode");
}

}  // namespace stickslip
