#include "sweep/files/records/signals.h"

#include <algorithm>
#include <iterator>

namespace stickslip {
namespace {

constexpr Signal signal_list[] = {
    {"time", &Record::time, Quantity::time, false},
    {"reference_position", &Record::reference_position, Quantity::position, false},
    {"reference_velocity", &Record::reference_velocity, Quantity::velocity, false},
    {"position", &Record::position, Quantity::position, true},
    {"velocity", &Record::velocity, Quantity::velocity, true},
    {"effort_command", &Record::effort_command, Quantity::effort, false},
    {"effort_measured", &Record::effort_measured, Quantity::effort, true},
    {"drive_voltage", &Record::drive, Quantity::voltage, false},
    {"duty", &Record::drive, Quantity::number, false},
    {"current", &Record::current, Quantity::current, true},
    {"supply_voltage", &Record::supply_voltage, Quantity::voltage, false},
    {"temperature", &Record::temperature, Quantity::temperature, false},
    {"torque_enable", &Record::torque_enable, Quantity::number, false},
    {"link_position", &Record::link_position, Quantity::position, true},
    {"feed_forward", &Record::feed_forward, Quantity::effort, false},
    {"load_effort", &Record::load_effort, Quantity::effort, false},
    {"inertia", &Record::inertia, Quantity::inertia, false},
    {"normal_load", &Record::normal_load, Quantity::number, false, true},
};

}  // namespace

std::span<const Signal> signals()
{
    return signal_list;
}

const Signal* signal_named(std::string_view name)
{
    const auto found =
        std::find_if(std::begin(signal_list), std::end(signal_list), [&](const Signal& s) { return s.name == name; });
    return found == std::end(signal_list) ? nullptr : found;
}

}  // namespace stickslip
