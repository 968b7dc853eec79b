// From journals to results.nc: chunks in order, a block at a time, into a file that appears only when it is whole.
#pragma once
#include "sweep/engine/chunk_index.h"
#include "sweep/engine/engine.h"
#include "sweep/engine/plan.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// How often each code of a coded column occurs.
struct CodeCounts {
    std::string column;
    std::array<std::uint64_t, 256> count{};
};

struct MergeReport {
    std::uint64_t points = 0;
    double seconds = 0;
    std::vector<CodeCounts> codes;  ///< one a coded column, in the order of the file
};

/// Writes all rows of the plan to `results` (its directory must exist). The same bytes for the same plan, however its
/// chunks are spread over journals. Memory: a block of rows and the largest record. The index must have every chunk.
/// Nothing if `options` interrupted it: then the old file, if any, stays.
/// Throws NetcdfError or std::system_error if the file cannot be written (the old one, if any, stays),
/// std::runtime_error if a record no longer verifies.
std::optional<MergeReport> write_results(const Plan& plan, const ChunkIndex& index,
                                         const std::filesystem::path& results, const EngineOptions& options = {});

/// Merges the journals of run directories that share one plan, such as those of shards; `results` may lie in one of
/// them. The journals go once the file is whole, unless they are to be kept; nothing if `results` was whole before and
/// they have gone. Throws Refused if they are of different sweeps, if one is in use, or if chunks are missing (and says
/// how many).
std::optional<MergeReport> merge(const std::vector<std::filesystem::path>& directories,
                                 const std::filesystem::path& results, bool keep_journals = false);

}  // namespace stickslip
