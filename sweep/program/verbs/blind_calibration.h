// blind --calibration: answered blind cases as a calibration for `diagnose --guarantee`.
#pragma once
#include "sweep/study/score.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stickslip {

/// Writes the cases that have an answer and a truth. `population`: how they were drawn. The name of a case is a hash of
/// its files, so that no draw counts twice.
void write_calibration(const std::filesystem::path& file, const std::string& population,
                       const std::vector<std::filesystem::path>& cases,
                       const std::map<std::string, blind::Answer>& answers,
                       const std::map<std::string, blind::Truth>& truths);

}  // namespace stickslip
