// run.json: what differs from run to run and so stays out of results.nc.
#pragma once
#include "sweep/engine/chunk_index.h"
#include "sweep/engine/engine.h"
#include "sweep/engine/merge.h"

#include <filesystem>
#include <optional>

namespace stickslip {

/// Wall time, machine, threads, points/s, resumed chunks, damage found. `merge` is absent where nothing was merged.
void write_run_record(const std::filesystem::path& path, const Plan& plan, RunEnd end, const ComputeReport& computed,
                      const ScanReport& scan, std::uint64_t resumed_chunks, Shard shard,
                      const std::optional<MergeReport>& merged);

}  // namespace stickslip
