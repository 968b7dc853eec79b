#include "sweep/cluster/mpi_chunks.h"

#include <mpi.h>

#include <chrono>

namespace stickslip {
namespace {

constexpr int claim_tag = 1, reply_tag = 2;
enum Request : std::uint64_t { claim_chunks, leave_sweep };

/// Short beside a chunk, long beside a look at the mailbox: the service thread takes no core from the computation.
constexpr std::chrono::microseconds nap{50};

}  // namespace

LeaderChunks::LeaderChunks(std::uint64_t chunks, int ranks, IsDone is_done)
    : is_done_(is_done), dispenser_(chunks, ranks, is_done), service_([this, ranks] { serve(ranks - 1); })
{
}

LeaderChunks::~LeaderChunks()
{
    if (service_.joinable()) service_.join();
}

void LeaderChunks::serve(int others)
{
    while (others > 0) {
        int waiting = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, claim_tag, MPI_COMM_WORLD, &waiting, &status);
        if (!waiting) {
            std::this_thread::sleep_for(nap);
            continue;
        }
        std::uint64_t request = 0;
        MPI_Recv(&request, 1, MPI_UINT64_T, status.MPI_SOURCE, claim_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (request == leave_sweep) {
            --others;
            continue;
        }
        const ChunkRange range = dispenser_.claim();
        const std::uint64_t reply[] = {range.first, range.end};
        MPI_Send(reply, 2, MPI_UINT64_T, status.MPI_SOURCE, reply_tag, MPI_COMM_WORLD);
    }
}

std::optional<std::uint64_t> LeaderChunks::next()
{
    for (;;) {
        const ChunkRange range = dispenser_.claim_one();
        if (range.empty()) return std::nullopt;
        if (!is_done_(range.first)) return range.first;
    }
}

void LeaderChunks::leave()
{
    dispenser_.close();  // an interrupted leader stops all; behind the last chunk there is nothing to close
    service_.join();
}

std::optional<std::uint64_t> FollowerChunks::next()
{
    const std::scoped_lock lock(mutex_);
    while (!exhausted_) {
        while (!batch_.empty()) {
            const std::uint64_t chunk = batch_.first++;
            if (!is_done_(chunk)) return chunk;
        }
        std::uint64_t request = claim_chunks, reply[2] = {0, 0};
        MPI_Send(&request, 1, MPI_UINT64_T, 0, claim_tag, MPI_COMM_WORLD);
        MPI_Recv(reply, 2, MPI_UINT64_T, 0, reply_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        batch_ = {reply[0], reply[1]};
        exhausted_ = batch_.empty();
    }
    return std::nullopt;
}

void FollowerChunks::leave()
{
    const std::uint64_t request = leave_sweep;
    MPI_Send(&request, 1, MPI_UINT64_T, 0, claim_tag, MPI_COMM_WORLD);
}

}  // namespace stickslip
