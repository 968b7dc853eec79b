// What the engine costs around the evaluation of a point, from claim to results.nc.
//
//   benchmark_engine [POINTS...]     default 1e3 1e4 1e5 1e6 1e7; 1e8 shows that memory stays flat (needs 7.2 GB of
//   disk)
//
// Files go to a directory under TMPDIR and are removed at the end. Times are wall times of one thread, so a disk that
// is slower than the computation shows; the column "sync" is the wait for it at the end of journal and results.nc.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "analysis/stability/verdict.h"
#include "sweep/engine/run_sweep.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/temporary_directory.h"

using namespace stickslip;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double peak_memory_mib()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

Axis log_axis(const char* path, Quantity quantity, std::size_t points, double from, double to)
{
    Axis axis{path, path, path, quantity, true, {}};
    for (std::size_t i = 0; i < points; ++i)
        axis.values.push_back(
            from *
            std::pow(to / from, static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, points - 1))));
    return axis;
}

/// A map over k_p and k_v at several velocities, of about that many points.
Plan plan_of(double points)
{
    const auto velocities = static_cast<std::size_t>(points >= 1e6 ? 100 : 10);
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(points / static_cast<double>(velocities))));
    return make_plan(example_joint(2e4, 10, 1e-3),
                     {log_axis("control.V0", Quantity::velocity, velocities, 1e-5, 1e-1),
                      log_axis("control.k_v", Quantity::damping, side, 1e-1, 1e4),
                      log_axis("control.k_p", Quantity::stiffness, side, 1e2, 1e6)},
                     {.title = "benchmark"});
}

/// Nanoseconds a point of evaluation alone: the same cursor, rows thrown away.
template <class PointFunction>
double bare(const Plan& plan, PointFunction f)
{
    const EvaluateChunk evaluate = point_by_point(f);
    PointCursor cursor(example_joint(2e4, 10, 1e-3), plan.axes);
    std::vector<PointResult> rows(plan.chunk_size);
    const std::uint64_t chunks = std::min<std::uint64_t>(plan.chunks(), 200);
    std::uint64_t points = 0;
    const auto start = Clock::now();
    for (std::uint64_t i = 0; i < chunks; ++i) {
        const PointRange range = plan.range(i * plan.chunks() / chunks);
        cursor.seek(range.first);
        evaluate(cursor, std::span(rows).first(range.count));
        points += range.count;
    }
    return 1e9 * since(start) / static_cast<double>(points);
}

/// Stands for an evaluation that costs nothing, so that what is left is the engine.
PointResult free_point(const Joint& joint)
{
    PointResult point;
    point.k_v_min = joint.control.k_p;
    point.spectral_abscissa = joint.control.k_v;
    return point;
}

template <class PointFunction>
void measure(const char* name, double wanted, PointFunction f, const fs::path& directory)
{
    const Plan plan = plan_of(wanted);
    const double alone = bare(plan, f);
    RunOptions options{.directory = directory, .fresh = true};
    options.engine.threads = 1;
    const auto start = Clock::now();
    const RunReport report = run_sweep(plan, example_joint(2e4, 10, 1e-3), point_by_point(f), options);
    const double whole = since(start);
    const double per_point = 1e9 / static_cast<double>(plan.points);
    std::printf("%-8s %10.0f %6.0f %9.1f %9.1f %9.1f %9.1f %9.1f %10.3f %8.0f\n", name,
                static_cast<double>(plan.points), static_cast<double>(plan.chunk_size), alone,
                report.computed.seconds * per_point, report.merged->seconds * per_point, whole * per_point,
                whole * per_point - alone, 1e-6 * static_cast<double>(plan.points) / whole, peak_memory_mib());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    std::vector<double> sizes;
    for (int i = 1; i < argc; ++i) sizes.push_back(std::atof(argv[i]));
    if (sizes.empty()) sizes = {1e3, 1e4, 1e5, 1e6, 1e7};
    const TemporaryDirectory directory;
    std::puts("one thread, wall time in ns a point; rate in million points/s a core, all in; peak memory in MiB");
    std::printf("%-8s %10s %6s %9s %9s %9s %9s %9s %10s %8s\n", "point", "points", "chunk", "bare", "compute",
                "results", "all in", "overhead", "rate", "memory");
    for (const double size : sizes) {
        measure("nothing", size, free_point, directory.path());
        measure(
            "linear", size, [](const Joint& joint) { return linear_point(joint); }, directory.path());
    }
}
