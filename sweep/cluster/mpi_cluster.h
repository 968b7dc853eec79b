// A cluster whose processes talk through MPI.
#pragma once
#include "sweep/engine/cluster.h"

namespace stickslip {

/// Begins MPI with the first and only one and ends it with it. Plain messages only: one-sided communication makes no
/// progress while rank 0 computes, and fails between nodes in Debian's Open MPI 4.1 (open-mpi/ompi issue 11466).
class MpiCluster : public Cluster {
  public:
    MpiCluster(int& argc, char**& argv);
    MpiCluster(const MpiCluster&) = delete;
    MpiCluster& operator=(const MpiCluster&) = delete;
    ~MpiCluster() override;

    int rank() const override { return rank_; }
    int ranks() const override { return ranks_; }
    std::vector<std::string> gather(const std::string& text) override;
    void broadcast(std::string& text) override;
    std::uint64_t sum(std::uint64_t number) override;
    std::unique_ptr<ClusterChunks> chunks(std::uint64_t chunks, IsDone is_done) override;
    [[noreturn]] void abort(const std::string& message) override;

  private:
    int rank_ = 0, ranks_ = 1;
    int stderr_copy_ = 2;  ///< where abort speaks, even on a rank whose output is silenced
};

}  // namespace stickslip
