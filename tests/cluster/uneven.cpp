// How evenly ranks share uneven work, and what a chunk costs beside its points. Prints, asserts nothing.
// Run: mpirun -np 4 --bind-to none cluster_uneven [--points N] [--chunk N] [--mean SECONDS] [--threads N]
// The points sleep, so that four ranks can be timed on fewer cores: their cost is log-uniform over three decades. The
// efficiency is the share of the workers' time that is spent on points; what a busy machine adds to a sleep counts as
// such.
#include "sweep/cluster/mpi_cluster.h"
#include "sweep/engine/run_on_cluster.h"
#include "tests/sweep/engine/sample_sweep.h"
#include "tests/temporary_directory.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

namespace {

using namespace sample;

struct Case {
    std::size_t points = 20'000;
    std::uint64_t chunk = 64;
    double mean = 1e-3;  // s
    int threads = 1;
};

Case case_from(int argc, char** argv)
{
    Case c;
    for (int i = 1; i + 1 < argc; i += 2) {
        const double value = std::atof(argv[i + 1]);
        if (!std::strcmp(argv[i], "--points")) c.points = static_cast<std::size_t>(value);
        if (!std::strcmp(argv[i], "--chunk")) c.chunk = static_cast<std::uint64_t>(value);
        if (!std::strcmp(argv[i], "--mean")) c.mean = value;
        if (!std::strcmp(argv[i], "--threads")) c.threads = static_cast<int>(value);
    }
    return c;
}

/// A uniform number in [0, 1) that belongs to the point.
double draw(std::uint64_t point)
{
    std::uint64_t x = point + 0x9e3779b97f4a7c15;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 27) * 0x94d049bb133111eb;
    return static_cast<double>((x ^ x >> 31) >> 11) * 0x1p-53;
}

double cost_of(std::uint64_t point, double mean)
{
    constexpr double decades = 3;
    const double least = mean * decades * std::log(10.0) / (std::pow(10.0, decades) - 1);
    return least * std::pow(10.0, decades * draw(point));
}

}  // namespace

int main(int argc, char** argv)
{
    stickslip::MpiCluster cluster(argc, argv);
    const Case c = case_from(argc, argv);
    const Plan p = plan({c.points}, c.chunk);
    const double first = p.axes[0].values.front(), step = c.points > 1 ? p.axes[0].values[1] - first : 1;
    std::atomic<std::uint64_t> nanoseconds = 0;  // on points, by all threads of this rank
    const EvaluateChunk sleeping = [&](PointCursor& cursor, std::span<PointResult> rows) {
        const auto start = std::chrono::steady_clock::now();
        double seconds = 0;
        for (PointResult& row : rows) {
            const auto number = static_cast<std::uint64_t>(std::llround((cursor.joint().control.k_p - first) / step));
            if (c.mean > 0) seconds += cost_of(number, c.mean);
            row = toy_point(cursor.joint());
            cursor.advance();
        }
        if (seconds > 0) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        nanoseconds += static_cast<std::uint64_t>((std::chrono::steady_clock::now() - start).count());
    };

    std::optional<TemporaryDirectory> directory;
    if (cluster.rank() == 0) directory.emplace();
    std::string where = directory ? directory->path().string() : std::string();
    cluster.broadcast(where);
    RunOptions options;
    options.directory = where;
    options.engine.threads = c.threads;
    const auto begin = std::chrono::steady_clock::now();
    const RunReport report = run_on_cluster(p, joint(), sleeping, options, cluster);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double work = 1e-9 * static_cast<double>(cluster.sum(nanoseconds));

    if (cluster.rank() == 0) {
        const double workers = static_cast<double>(cluster.ranks()) * c.threads,
                     chunks = static_cast<double>(p.chunks());
        std::printf("%d ranks x %d threads, %zu points, %llu a chunk: computed in %.3f s, with merge %.3f s",
                    cluster.ranks(), c.threads, c.points, static_cast<unsigned long long>(c.chunk),
                    report.computed.seconds, wall);
        if (c.mean > 0)
            std::printf("; work %.2f s, efficiency %.1f %%\n", work, 100 * work / workers / report.computed.seconds);
        else
            std::printf("; %.1f us a chunk, claim and journal included\n", 1e6 * report.computed.seconds / chunks);
    }
    return report.end == RunEnd::complete ? 0 : 1;
}
