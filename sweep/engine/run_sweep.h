// A sweep from plan to results.nc in one call: what the program's verbs use.
#pragma once
#include "sweep/engine/engine.h"
#include "sweep/engine/merge.h"
#include "sweep/engine/run_directory.h"

#include <filesystem>
#include <optional>
#include <string>

namespace stickslip {

struct RunOptions {
    std::filesystem::path directory;
    bool fresh = false;         ///< discard an earlier sweep of the directory instead of resuming or refusing
    Shard shard;                ///< a part of the sweep: journals only, `merge` makes results.nc of them
    bool keep_journal = false;  ///< leave the journals beside a whole results.nc, which holds all that they hold
    EngineOptions engine;
};

struct RunReport {
    RunEnd end = RunEnd::complete;
    std::string message;  ///< of write_failed, in words
    ComputeReport computed;
    ScanReport scan;
    std::uint64_t resumed_chunks = 0;   ///< found in the journals or in results.nc and not computed again
    std::optional<MergeReport> merged;  ///< set where results.nc was written
    std::filesystem::path results;      ///< set where results.nc is there and whole
};

/// Computes what the directory's journals lack, then writes results.nc and run.json and removes the journals. Where
/// results.nc is whole already, nothing is computed.
/// Ends early with `interrupted` or `write_failed` as values; both resume by the same call.
/// Throws std::invalid_argument if `base` is not the joint of the plan, Refused (run_directory.h) if the directory
/// cannot take the run, std::system_error if it cannot be written, std::runtime_error if journals contradict each
/// other.
RunReport run_sweep(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, const RunOptions& options);

}  // namespace stickslip
