// NLopt behind plain functions: where a function of several variables is least. Deterministic methods only.
#pragma once
#include <functional>
#include <vector>

namespace stickslip {

struct Bounds {
    std::vector<double> low, high;
};

/// NaN counts as infinitely large.
using Objective = std::function<double(const std::vector<double>&)>;

/// DIRECT-L over the whole box, without derivatives.
std::vector<double> global_minimum(const Objective& objective, const Bounds& bounds, int evaluations);

/// SBPLX from a start, with a first step as a share of the box.
std::vector<double> local_minimum(const Objective& objective, const Bounds& bounds, std::vector<double> start,
                                  double step, int evaluations);

/// COBYLA from a start under constraints g ≤ 0; the best point found that satisfies them to 1e-9, else the last one.
std::vector<double> constrained_minimum(const Objective& objective, const std::vector<Objective>& constraints,
                                        const Bounds& bounds, std::vector<double> start, double step, int evaluations);

}  // namespace stickslip
