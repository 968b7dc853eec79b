// calibration.json: answered cases whose causes are known, on disk. Files of several shards are read as one.
#pragma once
#include "sweep/study/guarantee/calibration.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// "stickslip-calibration/1" and every field of a calibration, under stable names.
std::string calibration_json(const guarantee::Calibration& calibration);

/// Throws std::invalid_argument for what is no calibration, with the place of the first error.
guarantee::Calibration parse_calibration(const std::string& json);

/// Reads one or more files as one calibration. Throws BadInput with the file's name, as merge() does.
guarantee::Calibration read_calibrations(const std::vector<std::string>& files);

/// The hash under which a calibration is of one joint only.
std::string hash_of(const Joint& joint);

}  // namespace stickslip
