#include "sweep/cluster/mpi_cluster.h"

#include "sweep/cluster/mpi_chunks.h"

#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace stickslip {

MpiCluster::MpiCluster(int& argc, char**& argv) : stderr_copy_(::dup(STDERR_FILENO))
{
    int given = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    if (given < MPI_THREAD_SERIALIZED) abort("this MPI library cannot be called from more than one thread");
}

MpiCluster::~MpiCluster()
{
    MPI_Finalize();
    ::close(stderr_copy_);
}

std::vector<std::string> MpiCluster::gather(const std::string& text)
{
    const int length = static_cast<int>(text.size());
    std::vector<int> lengths(rank_ == 0 ? static_cast<std::size_t>(ranks_) : 0), places(lengths.size());
    MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::exclusive_scan(lengths.begin(), lengths.end(), places.begin(), 0);
    std::string all(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)), '\0');
    MPI_Gatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), places.data(), MPI_CHAR, 0, MPI_COMM_WORLD);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < lengths.size(); ++i)
        texts.push_back(all.substr(static_cast<std::size_t>(places[i]), static_cast<std::size_t>(lengths[i])));
    return texts;
}

void MpiCluster::broadcast(std::string& text)
{
    int length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    text.resize(static_cast<std::size_t>(length));
    MPI_Bcast(text.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
}

std::uint64_t MpiCluster::sum(std::uint64_t number)
{
    std::uint64_t total = 0;
    MPI_Allreduce(&number, &total, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return total;
}

std::unique_ptr<ClusterChunks> MpiCluster::chunks(std::uint64_t chunks, IsDone is_done)
{
    if (rank_ == 0) return std::make_unique<LeaderChunks>(chunks, ranks_, std::move(is_done));
    return std::make_unique<FollowerChunks>(std::move(is_done));
}

void MpiCluster::abort(const std::string& message)
{
    ::dprintf(stderr_copy_, "stickslip: rank %d: %s\n", rank_, message.c_str());
    MPI_Abort(MPI_COMM_WORLD, 1);
    std::abort();  // MPI_Abort does not return, but does not say so
}

}  // namespace stickslip
