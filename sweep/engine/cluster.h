// Several processes that work on one sweep at once, on one machine or many. What they need of each other, and no more.
#pragma once
#include "sweep/engine/chunk_source.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace stickslip {

/// Chunks that the processes of a cluster claim from rank 0. While one lives, no other member of the cluster may be
/// called; every rank makes and leaves it.
class ClusterChunks : public ChunkSource {
  public:
    /// This process claims no more. Rank 0 returns when all others have said so, since it answers their claims until
    /// then.
    virtual void leave() = 0;
    /// On rank 0: chunks that have been claimed by any rank, and so are done or soon will be.
    virtual std::uint64_t claimed() const = 0;
};

/// All members but rank and ranks are called by every rank, in the same order.
class Cluster {
  public:
    virtual ~Cluster() = default;
    virtual int rank() const = 0;
    virtual int ranks() const = 0;

    /// The texts of all ranks, on rank 0; nothing on the others.
    virtual std::vector<std::string> gather(const std::string& text) = 0;
    /// Everyone's text becomes that of rank 0.
    virtual void broadcast(std::string& text) = 0;
    /// The sum over all ranks, on every rank.
    virtual std::uint64_t sum(std::uint64_t number) = 0;

    virtual std::unique_ptr<ClusterChunks> chunks(std::uint64_t chunks, IsDone is_done) = 0;

    /// Ends all ranks, because this one cannot go on and the others would wait for it.
    [[noreturn]] virtual void abort(const std::string& message) = 0;
};

}  // namespace stickslip
