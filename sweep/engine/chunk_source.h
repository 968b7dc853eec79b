// Who computes which chunk. Threads, shards and ranks differ in this one place and share everything else.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace stickslip {

/// Hands out chunk numbers, each at most once a run. next() is called from many threads at once.
class ChunkSource {
  public:
    virtual ~ChunkSource() = default;
    /// A chunk that nobody else of this run has or will get; nothing when there is none left for the caller's process.
    virtual std::optional<std::uint64_t> next() = 0;
};

/// Is this chunk in the journal already? Must be safe to call from many threads.
using IsDone = std::function<bool(std::uint64_t chunk)>;

/// All chunks in order, for the threads of one process.
class LocalChunks : public ChunkSource {
  public:
    LocalChunks(std::uint64_t chunks, IsDone is_done) : chunks_(chunks), is_done_(std::move(is_done)) {}
    std::optional<std::uint64_t> next() override;

  private:
    const std::uint64_t chunks_;
    const IsDone is_done_;
    std::atomic<std::uint64_t> claimed_{0};
};

/// One of `count` parts of a sweep that need not know of each other: a Slurm array task, a GNU parallel job.
struct Shard {
    std::uint64_t index = 0, count = 1;  ///< index counts from 0
    bool whole() const { return count == 1; }
};

/// Every count-th chunk of a fixed shuffle. Dealt, not hashed, so that shards are equally long to within one chunk;
/// shuffled, because the costly points of a sweep lie together.
class ShardChunks : public ChunkSource {
  public:
    ShardChunks(std::uint64_t chunks, Shard shard, IsDone is_done);
    std::optional<std::uint64_t> next() override;

    /// The k-th chunk of this shard, or nothing behind its last.
    std::optional<std::uint64_t> deal(std::uint64_t k) const;

  private:
    const std::uint64_t chunks_, stride_;
    const Shard shard_;
    const IsDone is_done_;
    std::atomic<std::uint64_t> claimed_{0};
};

}  // namespace stickslip
