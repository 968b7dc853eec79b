// Rank 0's side of the claims: which chunks go out next.
#pragma once
#include "sweep/engine/chunk_source.h"

#include <algorithm>
#include <cstdint>
#include <mutex>

namespace stickslip {

/// Consecutive chunk numbers, some of which may be done already.
struct ChunkRange {
    std::uint64_t first = 0, end = 0;
    bool empty() const { return first >= end; }
};

/// Thread-safe.
class Dispenser {
  public:
    Dispenser(std::uint64_t chunks, int ranks, IsDone is_done)
        : chunks_(chunks), ranks_(static_cast<std::uint64_t>(ranks)), is_done_(std::move(is_done))
    {
    }

    /// Guided: an equal share of a quarter of what is left, so that claims are few at first and the ranks end together.
    ChunkRange claim()
    {
        const std::scoped_lock lock(mutex_);
        const std::uint64_t left = chunks_ - next_;
        return hand_out(std::clamp<std::uint64_t>(left / (4 * ranks_), 1, most_at_once));
    }

    ChunkRange claim_one()
    {
        const std::scoped_lock lock(mutex_);
        return hand_out(1);
    }

    /// No more chunks for anyone.
    void close()
    {
        const std::scoped_lock lock(mutex_);
        next_ = chunks_;
    }

    /// Chunks handed out that were not done before.
    std::uint64_t claimed() const
    {
        const std::scoped_lock lock(mutex_);
        return claimed_;
    }

  private:
    static constexpr std::uint64_t most_at_once = 64;

    ChunkRange hand_out(std::uint64_t count)
    {
        while (next_ < chunks_ && is_done_(next_)) ++next_;
        const ChunkRange range{next_, std::min(next_ + count, chunks_)};
        next_ = range.end;
        for (std::uint64_t chunk = range.first; chunk < range.end; ++chunk)
            if (!is_done_(chunk)) ++claimed_;
        return range;
    }

    const std::uint64_t chunks_, ranks_;
    const IsDone is_done_;
    mutable std::mutex mutex_;
    std::uint64_t next_ = 0, claimed_ = 0;
};

}  // namespace stickslip
