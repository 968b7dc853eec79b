#include "sweep/engine/chunk_source.h"

#include <numeric>
#include <stdexcept>

namespace stickslip {
namespace {

/// k -> k · stride mod chunks is a shuffle when the two have no common factor; near the golden ratio neighbours fly far
/// apart.
std::uint64_t shuffle_stride(std::uint64_t chunks)
{
    constexpr double golden = 0.6180339887498949;
    auto stride = static_cast<std::uint64_t>(golden * static_cast<double>(chunks)) | 1;
    while (std::gcd(stride, chunks) != 1) ++stride;
    return stride;
}

}  // namespace

std::optional<std::uint64_t> LocalChunks::next()
{
    for (;;) {
        const std::uint64_t chunk = claimed_.fetch_add(1, std::memory_order_relaxed);
        if (chunk >= chunks_) return std::nullopt;
        if (!is_done_(chunk)) return chunk;
    }
}

ShardChunks::ShardChunks(std::uint64_t chunks, Shard shard, IsDone is_done)
    : chunks_(chunks), stride_(shuffle_stride(chunks)), shard_(shard), is_done_(std::move(is_done))
{
    if (shard.index >= shard.count) throw std::invalid_argument("a shard's index must be below the number of shards");
}

std::optional<std::uint64_t> ShardChunks::deal(std::uint64_t k) const
{
    const std::uint64_t place = shard_.index + shard_.count * k;
    if (place >= chunks_) return std::nullopt;
    return static_cast<std::uint64_t>(static_cast<unsigned __int128>(place) * stride_ % chunks_);
}

std::optional<std::uint64_t> ShardChunks::next()
{
    for (;;) {
        const auto chunk = deal(claimed_.fetch_add(1, std::memory_order_relaxed));
        if (!chunk || !is_done_(*chunk)) return chunk;
    }
}

}  // namespace stickslip
