// The files of a blind test case: what the diagnosis may see, and what it may not.
#pragma once
#include "tests/blind/generate/cases.h"

#include <filesystem>
#include <map>
#include <string>

namespace blind {

/// The nominal joint in the pinned format. Noise is stated only where the case says so.
/// A record whose gains differ gets an override.
std::string joint_toml(const Setting& setting);
/// A record with the columns of the case; ten significant digits.
std::string record_csv(const Record& record, const Machine& machine, const Columns& columns);
/// Writes joint.toml and record-N.csv.gz into `folder`. The same case gives the same bytes.
void write_case(const SealedCase& c, const std::filesystem::path& folder);
/// What was put in, as JSON text; `engine` is who simulated it. Cases that `earlier` (such a text, or empty) has are
/// kept.
std::string truth_json(const std::map<std::string, SealedCase>& cases, const std::string& engine,
                       const std::string& earlier = "");

}  // namespace blind
