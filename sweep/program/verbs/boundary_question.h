// The questions of `stickslip boundary`, from its command line and the [boundary] table of a spec.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "sweep/files/toml/asked_axes.h"

#include <array>
#include <string>
#include <vector>

namespace stickslip {

struct BoundaryOptions {
    std::string input, directory;
    std::vector<std::string> kinds, along, over, settings;
    std::string disturbance;
    double size = missing, precision = not_set, max_undecided = 0.05;
    int guard = 0, threads = 0;  ///< guard 0: that of the spec, else of the kind
    bool ideal_loop = false, json = false;
};

/// One kind along one axis, or over two.
struct BoundaryQuestion {
    BoundaryRequest request;
    std::vector<Axis> axes;
};

/// Every question that is asked, judged as a whole before the first is answered. The command line goes before the
/// [boundary] table, that before the axes and charts of the spec. Throws BadInput.
std::vector<BoundaryQuestion> boundary_questions(const Asked& asked, const BoundaryOptions& options);

/// Each axis of a linear boundary once.
std::vector<Axis> linear_axes(const std::vector<BoundaryQuestion>& questions);

/// "position of 0.0001 m", mark-up: what an outcome follows.
std::string disturbance_text(const Disturbance& disturbance, Units units);

}  // namespace stickslip
