#include "sweep/files/records/signals.h"

#include <algorithm>
#include <iterator>

namespace stickslip {
namespace {

constexpr Signal signal_list[] = {
    {"time", &Record::time, Quantity::time, false, false, "of the row, rising"},
    {"reference_position", &Record::reference_position, Quantity::position, false, false,
     "the command to the controller"},
    {"reference_velocity", &Record::reference_velocity, Quantity::velocity, false, false,
     "the command to the controller"},
    {"position", &Record::position, Quantity::position, true, false, "measured where control.feedback says"},
    {"velocity", &Record::velocity, Quantity::velocity, true, false, "measured, or as the controller estimates it"},
    {"effort_command", &Record::effort_command, Quantity::effort, false, false, "the controller's output"},
    {"effort_measured", &Record::effort_measured, Quantity::effort, true, false,
     "effort on the mechanism, by a sensor or from the current"},
    {"drive_voltage", &Record::drive, Quantity::voltage, false, false,
     "voltage at the motor (actuator.signal = \"voltage\")"},
    {"duty", &Record::drive, Quantity::number, false, false,
     "share of the supply, -1 to 1 (actuator.signal = \"duty\")"},
    {"current", &Record::current, Quantity::current, true, false, "motor current"},
    {"supply_voltage", &Record::supply_voltage, Quantity::voltage, false, false, "of the bus"},
    {"temperature", &Record::temperature, Quantity::temperature, false, false, "of the joint"},
    {"torque_enable", &Record::torque_enable, Quantity::number, false, false, "0: the drive is off, anything else: on"},
    {"link_position", &Record::link_position, Quantity::position, true, false, "measured behind the transmission"},
    {"feed_forward", &Record::feed_forward, Quantity::command, false, false,
     "what the controller adds to its own output"},
    {"load_effort", &Record::load_effort, Quantity::effort, false, false,
     "known load on the link, positive in the direction of motion"},
    {"load_error", &Record::load_error, Quantity::effort, false, false,
     "an example of what load_effort is wrong by, as arm-load writes it: it counts as noise"},
    {"inertia", &Record::inertia, Quantity::inertia, false, false, "of the link where it changes"},
    {"normal_load", &Record::normal_load, Quantity::number, false, true,
     "on the friction, in a unit of its own (friction rigs)"},
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
