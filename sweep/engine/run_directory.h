// The directory that a sweep writes into: who may write, and which plan lives there.
#pragma once
#include "sweep/engine/chunk_source.h"
#include "sweep/engine/plan.h"
#include "sweep/engine/posix.h"

#include <filesystem>
#include <stdexcept>

namespace stickslip {

/// A directory that cannot take this run; the message says why and what to do. Nothing in it was touched.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The files of a run directory.
namespace run_files {
inline constexpr char plan[] = "plan.json", results[] = "results.nc", run[] = "run.json", journals[] = "journal",
                      lock[] = "lock";
}

/// A run directory, locked for as long as this lives. A whole sweep and a merge hold it alone; shards share it with
/// other shards.
class RunDirectory {
  public:
    /// Makes the directory for a new sweep, or opens it to resume the same one.
    /// Throws Refused if another run works in it, if it holds another sweep or results of unknown origin (the way out
    /// is `fresh`, which removes them and is not for shards), or if the disk is too small; std::system_error if it
    /// cannot be written.
    RunDirectory(std::filesystem::path path, const Plan& plan, Shard shard, bool fresh);

    /// Opens an existing directory alone, to merge it. Throws Refused.
    explicit RunDirectory(std::filesystem::path path);

    /// The plan as it was first written here: same id as the present plan, with the provenance of the first run.
    const Plan& plan() const { return plan_; }

    std::filesystem::path file(const char* name) const { return path_ / name; }

    /// Whether results.nc is there for this plan. It appears only when it is whole, so one that names the plan is.
    bool has_results() const;

    /// What has become results.nc is no longer needed. Where the file system will not let go, it stays: no harm is
    /// done.
    void remove_journals() const;

  private:
    void lock(Shard shard);
    void admit(const Plan& wanted, bool fresh);
    void check_space(const Plan& plan, Shard shard) const;

    std::filesystem::path path_;
    FileHandle lock_, shard_lock_;
    Plan plan_;
};

/// Whether a results file is there and is that of the plan.
bool holds_results(const std::filesystem::path& results, const Plan& plan);

/// The plan that a directory holds. Throws Refused if there is none that can be read.
Plan read_plan(const std::filesystem::path& directory);

}  // namespace stickslip
