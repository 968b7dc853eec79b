// Claims by messages: rank 0 computes too, and a thread of its own answers the others.
#pragma once
#include "sweep/cluster/dispenser.h"
#include "sweep/engine/cluster.h"

#include <mutex>
#include <thread>

namespace stickslip {

/// Rank 0. Its threads take from the dispenser directly; only the service thread calls MPI while this lives.
class LeaderChunks : public ClusterChunks {
  public:
    LeaderChunks(std::uint64_t chunks, int ranks, IsDone is_done);
    ~LeaderChunks() override;
    std::optional<std::uint64_t> next() override;
    void leave() override;
    std::uint64_t claimed() const override { return dispenser_.claimed(); }

  private:
    void serve(int others);
    const IsDone is_done_;
    Dispenser dispenser_;
    std::thread service_;
};

/// Any other rank: its threads share one batch, and the first to find it empty fetches the next.
class FollowerChunks : public ClusterChunks {
  public:
    explicit FollowerChunks(IsDone is_done) : is_done_(std::move(is_done)) {}
    std::optional<std::uint64_t> next() override;
    void leave() override;
    std::uint64_t claimed() const override { return 0; }

  private:
    const IsDone is_done_;
    std::mutex mutex_;  ///< also keeps MPI calls apart
    ChunkRange batch_;
    bool exhausted_ = false;
};

}  // namespace stickslip
