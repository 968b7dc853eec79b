// Registers of servo drives as gains in SI: control.servo = "dynamixel-xl330", control.registers = { P = 400, I = 0 }.
// Internal to sweep/files.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "sweep/files/text/toml_input.h"

namespace stickslip::files {

/// What the registers say of keys of the joint, by their paths; choices by name.
struct ServoGains {
    std::string servo, source;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> choices;
};

/// Names of the drives whose conversions their makers publish.
std::vector<std::string> servo_names();

/// Reads control.servo and control.registers of a joint's table; no servo: nothing. What does not fit goes to
/// `complaints`.
ServoGains servo_gains(const toml::table& root, Complaints& complaints);

}  // namespace stickslip::files
