// The reference of a joint, from a file, and the record of what it did, to one.
#pragma once
#include "analysis/simulation/sampled/loop_record.h"

#include <filesystem>

namespace stickslip {

/// CSV or .csv.gz with time and reference_position, and reference_velocity and feed_forward where it has them; two
/// columns need no header. Units in brackets are converted. Throws BadInput with the place of what does not fit.
ReferenceMotion read_reference(const std::filesystem::path& file, Units units);

/// DIRECTORY/record.csv, with the columns that `diagnose` reads; returns its path.
std::filesystem::path write_record(const LoopRecord& record, const std::filesystem::path& directory);

}  // namespace stickslip
