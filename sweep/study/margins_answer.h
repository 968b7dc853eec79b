// How far a design is from its boundaries: in all directions at once, one parameter at a time, and at worst.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/loop/loop_use.h"
#include "sweep/study/idle_axes.h"
#include "sweep/study/left_out_loop.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace stickslip {

inline constexpr double shown_growth = 4;  ///< per |max Re s| of the joint: what grows faster would flatten the rest

/// max Re s while one parameter moves, over its multiple.
struct GrowthByParameter {
    double reach = 0;            ///< the logarithm of the largest change, a little beyond the farthest boundary
    std::vector<Samples> lines;  ///< as MarginsAnswer::alone, empty where there is no boundary; NaN outside the window
};

enum class RobustClass {
    robust,        ///< every joint of the uncertainty slides
    nominal_only,  ///< the joint as described slides, the worst case does not
    unstable,      ///< the joint as described sticks and slips
    no_verdict
};

/// Classes of the points of a chart, row-major, x fastest.
struct RobustSet {
    Axis x, y;
    std::vector<RobustClass> classes;
};

/// Everything a question about margins was answered with.
struct MarginsAnswer {
    std::string title, command;
    Joint joint;
    LoopUse loop;                              ///< of the verdicts
    std::optional<LeftOutLoop> left_out = {};  ///< with --ideal-loop
    Reason reason = Reason::none;              ///< why it has no verdict, and so no margin
    NearestBoundary nearest;
    double tolerance_each = missing;     ///< share by which all its parameters may be off at once without reaching it
    std::vector<NearestBoundary> alone;  ///< one parameter each
    std::vector<Coordinate> alone_of;
    std::optional<std::size_t> shortest_alone;  ///< of `alone`: which has the shortest way to its boundary
    Uncertainty uncertainty;
    std::optional<WorstCase> worst;
    std::vector<IdleAxis> idle = {};  ///< uncertain parameters and axes that no linear verdict depends on
    std::optional<FollowedBoundary> nominal, robust;  ///< over two axes
    std::optional<RobustSet> robust_set;              ///< only for a page with `robust` and `nominal`
    std::optional<GrowthByParameter> growth;          ///< only for a page, and where a parameter has a boundary

    /// Whether no linear answer depends on any of the uncertain parameters: their worst joint says nothing.
    bool only_idle() const
    {
        return std::ranges::all_of(uncertainty.coordinates,
                                   [&](const auto& c) { return c.less.empty() && idle_axis(idle, c.path); });
    }
};

/// The margins of a joint: its natural coordinates for the nearest boundary, those and both gains one by one.
MarginsAnswer margins_of(const Joint& joint);

/// Nothing where no parameter alone has a boundary.
std::optional<GrowthByParameter> growth_by_parameter(const MarginsAnswer& answer);

}  // namespace stickslip
