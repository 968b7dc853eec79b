// A joint that stands in a TOML table which others read too. Internal to sweep/files.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/text/toml_input.h"

namespace stickslip::files {

/// Reads the joint's tables from `root`; `also_allowed` are top-level keys with other readers. Files that it names
/// are looked up from `folder`. Errors go to
/// `complaints`.
Joint joint_from(const toml::table& root, Complaints& complaints, const std::vector<std::string>& also_allowed,
                 const std::filesystem::path& folder);

}  // namespace stickslip::files
