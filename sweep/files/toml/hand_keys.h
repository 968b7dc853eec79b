// Keys whose values are no single number, word or flag, so that no struct declares them: each once, for its reader, for
// the list of what is allowed beside it, and for the reference.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::files {

struct HandKey {
    std::string_view table, name;  ///< no table: at the top of the file
    std::string_view takes, standard, help;
};

inline constexpr HandKey spec_keys[] = {
    {"", "title", "text", "-", "of the report"},
    {"", "joint", "text", "-",
     "joint file, relative to this file; without it, this file contains the tables of the joint"},
    {"axes", "from", "number, or text with a unit", "required", "first value of the axis"},
    {"axes", "to", "number, or text with a unit", "required", "last value of the axis, above from"},
    {"axes", "points", "whole number within [1, 1000000]", "required", "number of values, both ends included"},
    {"axes", "scale", "log, linear", "linear", "spacing of the values; log needs values > 0"},
    {"axes", "values", "list of ascending numbers", "-", "the values themselves, in place of from, to and points"},
    {"robot", "file", "text", "required", "robot description, URDF or MJCF, relative to this file"},
    {"robot", "joint", "text", "required", "which of its joints this one is"},
    {"robot", "armature", "number, or text with a unit", "0",
     "inertia of a rotor behind its gear that the description lacks; of several masses the joint has the motor's"},
    {"robot", "description", "text", "-", "the description itself, in place of file, as results.nc has it"},
    {"report", "title", "text", "title", "heading of the page"},
    {"report", "charts", "pair of axes, or a list of pairs", "chosen", "which maps are drawn, x then y"},
    {"report", "surfaces", "pair of axes, or a list of pairs", "chosen", "which surfaces are drawn, x then y"},
    {"boundary", "kind", "text, or a list", "both linear theories", "kinds of boundary: see stickslip boundary --help"},
    {"boundary", "along", "PATH or PATH=FROM..TO, or a list", "the axes", "axes along which boundaries are located"},
    {"boundary", "over", "two of PATH or PATH=FROM..TO", "the charts", "the plane in which boundaries are followed"},
    {"boundary", "axis", "as along", "the axes", "another name of along"},
    {"requirements", "uncertain", "table of PATH = share", "none", "uncertain parameters, each with its share"},
};

inline constexpr HandKey joint_keys[] = {
    {"control", "servo", "dynamixel-xl330, dynamixel-xc330, dynamixel-xm430, moteus, odrive", "none",
     "drive whose register values set the gains"},
    {"control", "registers", "table of register = number", "none",
     "P, I, D of a dynamixel; kp, ki, kd, ilimit of a moteus; pos_gain, vel_gain, vel_integrator_gain of an odrive"},
};

inline constexpr HandKey record_keys[] = {
    {"record", "columns", "table of signals", "-", "which column of the file is which signal"},
    {"record", "constants", "table of signals", "-", "signals without a column: one value for all rows"},
    {"record", "at_rest_at_start", "true, false", "found out", "whether the joint is at rest in the first row"},
    {"record", "files", "table of file patterns", "-",
     "settings for files of this name only: columns, constants, at_rest_at_start, and numbers of the joint"},
};

inline constexpr HandKey record_column_keys[] = {
    {"record.columns.SIGNAL", "name", "text", "the signal's", "the column's name in the file"},
    {"record.columns.SIGNAL", "unit", "text", "SI", "unit of the column"},
    {"record.columns.SIGNAL", "scale", "number, not 0", "1", "SI value = scale · value + offset"},
    {"record.columns.SIGNAL", "offset", "number, or text with a unit", "0", "added after the scale"},
};

/// The keys of one table, as they stand in it.
template <std::size_t n>
std::vector<std::string> names_of(const HandKey (&keys)[n], std::string_view table)
{
    std::vector<std::string> names;
    for (const auto& key : keys)
        if (key.table == table) names.emplace_back(key.name);
    return names;
}

}  // namespace stickslip::files
