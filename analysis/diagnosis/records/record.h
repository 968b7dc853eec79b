// A measured record of one joint as plain arrays. Readers fill it, the diagnosis reads it; SI units throughout.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// Columns of equal length, row k at time[k]; a column that was not logged is empty. A missing value is NaN.
/// Signs and timing follow the sampled loop: position is what the encoder said, effort_command what the controller
/// then commanded and held until the next tick, effort_measured what reached the mechanism just after that update.
struct Record {
    std::string name;                        ///< file name, for reports
    std::vector<double> time;                ///< s
    std::vector<double> reference_position;  ///< m | rad
    std::vector<double> reference_velocity;  ///< m/s | rad/s
    std::vector<double> position;            ///< m | rad: the encoder that the controller reads
    std::vector<double> velocity;            ///< m/s | rad/s: the controller's own estimate
    std::vector<double> effort_command;      ///< N | N·m, or the unit of the drive signal that effort_gain converts
    std::vector<double> effort_measured;     ///< N | N·m
    std::vector<double> drive;               ///< V, or duty −1…1: the drive signal where no effort is commanded
    std::vector<double> current;             ///< A
    std::vector<double> supply_voltage;      ///< V
    std::vector<double> temperature;         ///< °C
    std::vector<double> torque_enable;       ///< 0 or 1
    std::vector<double> link_position;       ///< m | rad: a second encoder, on the link
    std::vector<double> feed_forward;        ///< in the unit of the command: what was added to the controller's own
    std::vector<double> load_effort;         ///< N | N·m: a known load on the link, positive along the motion
    std::vector<double> load_error;          ///< N | N·m: an example of what load_effort is wrong by, row by row
    std::vector<double> inertia;      ///< kg | kg·m²: the inertia that moves (two-mass: the link's) in this row
    std::vector<double> normal_load;  ///< normal stress or force of a friction rig, in its own unit
    std::vector<std::pair<std::string, double>>
        overrides;                         ///< dotted path of the joint → value that held in this record
    std::optional<bool> at_rest_at_start;  ///< not said: the motion of the first rows tells
    std::optional<double> began;           ///< s, of `time`: what comes with time counts from here; not said: row 0

    /// Length of every column that was logged.
    std::size_t rows() const { return time.size(); }
};

}  // namespace stickslip
