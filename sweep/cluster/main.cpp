// stickslip-mpi: the program with every rank of an MPI job at work on its sweep. All other verbs run on rank 0.
#include "sweep/cluster/mpi_cluster.h"
#include "sweep/program/program.h"

#include <cstdio>
#include <string_view>

int main(int argc, char** argv)
{
    stickslip::MpiCluster cluster(argc, argv);
    // All ranks run the same command and would all print the same words.
    if (cluster.rank() != 0 && !(std::freopen("/dev/null", "w", stdout) && std::freopen("/dev/null", "w", stderr)))
        cluster.abort("/dev/null cannot be opened");
    const bool sweeps = argc > 1 && std::string_view(argv[1]) == "sweep";
    if (cluster.rank() != 0 && !sweeps) return 0;
    return stickslip::run_program(argc, argv, &cluster);
}
