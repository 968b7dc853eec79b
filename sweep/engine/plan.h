// What a sweep computes, settled before it starts: numbered points in fixed chunks, and one id that says "the same
// sweep".
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/stability_map.h"
#include "sweep/engine/plan_cost.h"

#include <cstdint>
#include <string>
#include <vector>

namespace stickslip {

/// XXH3-128 of everything that determines the numbers of a sweep.
struct PlanId {
    std::uint64_t high = 0, low = 0;
    bool operator==(const PlanId&) const = default;
};

/// 32 hexadecimal digits.
std::string to_text(const PlanId& id);

/// Consecutive points that are computed, journalled and resumed together.
struct PointRange {
    std::uint64_t first = 0, count = 0;
};

/// A sweep as data that can be written down and read back (plan_file.h). Point numbers are row-major: the first axis is
/// the slowest.
struct Plan {
    std::vector<Axis> axes;  ///< none: the sweep is one point, the joint as it stands
    Units units;
    std::string joint;       ///< canonical_text of the joint that the axes vary
    std::string options;     ///< canonical text of all options of the evaluation
    bool nonlinear = false;  ///< rows have the columns of the nonlinear joint too
    std::string build;       ///< build_fingerprint() of the program that computes it
    std::uint64_t points = 0;
    std::uint64_t chunk_size = 0;
    PlanId id;  ///< of all fields above

    // Provenance goes into results.nc beside the numbers and does not change them: not part of the id.
    std::string title, spec, command, version;

    std::uint64_t chunks() const { return (points + chunk_size - 1) / chunk_size; }
    PointRange range(std::uint64_t chunk) const
    {
        const std::uint64_t first = chunk * chunk_size;
        return {first, points - first < chunk_size ? points - first : chunk_size};
    }
};

/// What a plan needs beyond joint and axes.
struct PlanOptions {
    std::string evaluation;  ///< canonical text of the options of the evaluation; equal text must mean equal results
    bool nonlinear = false;
    double seconds_per_point = linear_point_cost;
    bool dense = false;  ///< few points of a chunk are computed, the others lie between: chunks are boxes of the axes
    std::string title;
    std::string spec;     ///< the spec as the user wrote it
    std::string command;  ///< reproduces the sweep; without --threads, --shard and -o, so that results.nc does not
                          ///< depend on them
};

/// Settles a sweep of the joint over the axes.
/// Throws std::invalid_argument, naming the axis, for a path that the joint lacks or that is given twice, an empty
/// axis, a value that is not finite or outside the parameter's range, and for more than max_points points.
Plan make_plan(const Joint& joint, std::vector<Axis> axes, const PlanOptions& options);

/// A power of two near 0.1 s of work, smaller for small sweeps (so that threads share them), larger for huge ones (so
/// that the index of chunks stays small). Depends on its arguments alone.
std::uint64_t chunk_size_for(std::uint64_t points, double seconds_per_point);

/// Of a dense sweep: whole last axes and a share of the one before, near 0.3 s of work where one point in twenty is
/// computed. Boxes of thousands of points, as small ones are mostly computed.
std::uint64_t dense_chunk_size_for(const std::vector<Axis>& axes, double seconds_per_point);

/// The id that the fields of the plan ask for; a plan read from a file must agree with it.
PlanId id_of(const Plan& plan);

}  // namespace stickslip
