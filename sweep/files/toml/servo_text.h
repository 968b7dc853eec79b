// What the registers of a servo drive came to, for the user who evaluates the joint.
#pragma once
#include <filesystem>
#include <string>

namespace stickslip::files {

/// A sentence that says which keys the registers of this joint file filled; empty without a servo.
std::string servo_text(const std::filesystem::path& joint_file);

}  // namespace stickslip::files
