// The boundary of the full joint and of its reductions over a slice of a sweep.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/study/maps.h"
#include "sweep/study/samples.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// One reduction over a chart.
struct ReducedModel {
    std::string model, assumption;
    Samples boundary;                             ///< NaN separates pieces
    double wrong_stable = 0, wrong_unstable = 0;  ///< shares of the chart that it calls so wrongly
    double wrong() const { return wrong_stable + wrong_unstable; }
};

struct ReducedMap {
    Samples full;  ///< boundary of the full joint
    std::vector<ReducedModel> models;
    std::size_t columns = 0, rows = 0;  ///< of the grid on which verdicts were compared
};

/// Over the axes of a slice, which are numbers of the full joint: each point is reduced anew, so that both sides mean
/// the same machine. Nothing for a single mass or where every reduction refuses the joint.
std::optional<ReducedMap> compare_reductions(const Joint& design, const Slice& slice);

}  // namespace stickslip
