// One joint's columns in a table that holds those of several joints.
#pragma once
#include "sweep/files/records/record_layout.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// What a table says of one joint.
struct JointColumns {
    bool present = false;             ///< it has a measured signal of this joint
    std::vector<std::string> joints;  ///< that the names of its columns tell of, in the order of the columns
    RecordLayout layout;              ///< to read this joint with
};

/// The joints that the names of columns tell of, in the order of the columns.
std::vector<std::string> joints_named_in(const std::vector<std::string>& columns);

/// `{joint}` in the names of columns becomes this name.
RecordLayout layout_for_joint(RecordLayout layout, const std::string& joint);

/// Finds the columns of a joint: those that the layout names, then NAME and signal joined by one of _ . / : - either
/// way round, or signal[NAME]. Signals without a joint in their name (time, supply_voltage, temperature) belong to
/// every joint; a plain `position` to none. Throws BadInput where the file cannot be read or has no header.
JointColumns joint_columns(const std::filesystem::path& table, const std::string& joint, RecordLayout layout);

}  // namespace stickslip
