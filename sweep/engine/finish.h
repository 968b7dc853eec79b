// The end of a sweep whose chunks are all journalled. Internal to sweep/engine.
#pragma once
#include "sweep/engine/run_sweep.h"

namespace stickslip {

/// Writes results.nc, removes the journals unless they are to be kept, and sets end, message, merged and results of the
/// report.
void finish(const RunDirectory& directory, const ChunkIndex& index, const RunOptions& options, RunReport& report);

/// A sweep whose results.nc is whole: nothing is left to do but what a kill behind its writing left undone.
void finish_again(const RunDirectory& directory, const RunOptions& options, RunReport& report);

}  // namespace stickslip
