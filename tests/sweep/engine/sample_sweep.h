// A small joint, plans over it and a cheap evaluation, for the tests of the engine.
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "sweep/engine/plan.h"
#include "sweep/engine/run_sweep.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/temporary_directory.h"

namespace sample {

namespace fs = std::filesystem;
using namespace stickslip;

inline Joint joint()
{
    return example_joint(2e4, 10, 1e-3);
}

inline Axis axis(const std::string& path, std::size_t points, double from, double to,
                 Quantity quantity = Quantity::number)
{
    Axis axis{path, path, "axis " + path, quantity, false, {}};
    for (std::size_t i = 0; i < points; ++i)
        axis.values.push_back(
            points == 1 ? from : from + (to - from) * static_cast<double>(i) / static_cast<double>(points - 1));
    return axis;
}

/// Up to five axes over the sample joint with that many points each.
inline std::vector<Axis> axes(const std::vector<std::size_t>& shape)
{
    const std::vector<Axis> all{
        axis("control.k_p", 1, 1e3, 1e5, Quantity::stiffness), axis("control.k_v", 1, 0, 100, Quantity::damping),
        axis("control.V0", 1, 1e-4, 1e-2, Quantity::velocity), axis("friction.A", 1, 0.5, 2, Quantity::effort),
        axis("joint.inertia", 1, 0.5, 2, Quantity::inertia)};
    const double to[] = {1e5, 100, 1e-2, 2, 2};
    std::vector<Axis> chosen;
    for (std::size_t i = 0; i < shape.size(); ++i)
        chosen.push_back(axis(all[i].path, shape[i], all[i].values[0], to[i], all[i].quantity));
    return chosen;
}

/// A plan over the sample joint; a chunk size of 0 leaves the choice to make_plan.
inline Plan plan(const std::vector<std::size_t>& shape, std::uint64_t chunk_size = 0, const std::string& options = "")
{
    Plan plan = make_plan(joint(), axes(shape),
                          {.evaluation = options, .title = "sample", .spec = "# sample\n", .command = "sample"});
    if (chunk_size) plan.chunk_size = chunk_size;
    plan.id = id_of(plan);
    return plan;
}

/// Every column filled from the parameters, with missing numbers and all codes; exact, so equal on every machine.
inline PointResult toy_point(const Joint& joint)
{
    const auto& law = std::get<RateAndState>(joint.friction.law);
    PointResult point;
    point.k_v_min = joint.control.k_p * 0.5 + joint.control.k_v;
    point.spectral_abscissa = joint.control.k_v - joint.control.V0;
    if (joint.control.k_v > 20) point.k_cr = joint.control.k_p + law.A;
    point.omega = joint.mechanism.inertia + joint.control.V0;
    const auto code = static_cast<std::uint64_t>(joint.control.k_p + joint.control.k_v * 7 + law.A * 3);
    point.region = static_cast<Region>(code % 6);
    point.velocity_only_stable = code % 2;
    point.state_variable_stable = code % 3 == 0;
    point.reason = joint.control.k_v > 20 ? Reason::none : Reason::not_finite;
    return point;
}

inline RunReport run(const Plan& plan, const fs::path& directory, int threads = 1, Shard shard = {}, bool fresh = false,
                     bool keep_journal = false)
{
    RunOptions options;
    options.directory = directory;
    options.shard = shard;
    options.fresh = fresh;
    options.keep_journal = keep_journal;
    options.engine.threads = threads;
    return run_sweep(plan, joint(), point_by_point(toy_point), options);
}

/// With the journals left beside the results.
inline RunReport run_kept(const Plan& plan, const fs::path& directory, int threads = 1)
{
    return run(plan, directory, threads, {}, false, true);
}

inline std::string bytes(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void set_bytes(const fs::path& path, const std::string& content)
{
    std::ofstream(path, std::ios::binary) << content;
}

/// The journals of a run directory.
inline std::vector<fs::path> journals(const fs::path& directory)
{
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(directory / run_files::journals)) found.push_back(entry.path());
    return found;
}

}  // namespace sample
