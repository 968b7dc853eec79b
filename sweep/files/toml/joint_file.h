// A joint from TOML and back. The keys, units, ranges and help are those of Joint::fields; nothing is listed twice.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/text/bad_input.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// Reads joint.toml. Numbers are SI, or text with a unit ("1 mm/s"). A [record] table may stand in the file; it is read
/// by read_record_layout. Throws BadInput with every error of the file, each `file:line:column: path: …`.
Joint read_joint(const std::filesystem::path& file);

/// The same from text; `name` is what messages call it, `folder` where files that it names (a kernel table) are looked
/// up.
Joint read_joint_text(std::string_view text, const std::string& name, const std::filesystem::path& folder = {});

/// Applies one `path=value` as the command line gives it: "control.k_p=2e4", "control.V0=1 mm/s",
/// "friction.law=stribeck", "friction.B=[1, 2]", "friction.B.1=2". A new law or model starts with its numbers not set;
/// later settings fill them. Throws BadInput and leaves the joint as it was.
void apply_setting(Joint& joint, std::string_view setting);

/// Applies all in order, then requires the joint to be complete. Throws BadInput with every error.
void apply_settings(Joint& joint, const std::vector<std::string>& settings);

/// The joint as TOML with units in comments. What equals its default is left out, choices are always written.
/// read_joint_text(joint_text(j)) equals j.
std::string joint_text(const Joint& joint);

}  // namespace stickslip
