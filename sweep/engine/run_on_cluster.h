// The sweep of run_sweep.h by all processes of a cluster.
#pragma once
#include "sweep/engine/cluster.h"
#include "sweep/engine/run_sweep.h"

namespace stickslip {

/// Called by every rank with the same arguments. Rank 0 locks the directory, which all ranks must see, finds out what
/// is left, hands out chunks while it computes too, and writes results.nc; each rank journals what it has computed. The
/// same bytes as run_sweep. RunReport is that of the whole cluster, on every rank; `results` and `merged` are set on
/// rank 0. Throws on every rank what run_sweep throws on rank 0, and Refused if a rank has another plan, build or kind
/// of CPU or does not see the directory.
RunReport run_on_cluster(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, const RunOptions& options,
                         Cluster& cluster);

}  // namespace stickslip
