// The end of a sweep whose chunks are all journalled. Internal to run_sweep and run_on_cluster.
#pragma once
#include "sweep/engine/run_sweep.h"

namespace stickslip {

/// Writes results.nc unless it is there already and nothing was computed; sets end, message, merged and results of the
/// report.
void finish(const RunDirectory& directory, const ChunkIndex& index, const EngineOptions& options, RunReport& report);

}  // namespace stickslip
