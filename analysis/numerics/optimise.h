// NLopt behind plain functions: where a function of several variables is least. Deterministic methods only.
#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace stickslip {

struct Bounds {
    std::vector<double> low, high;
};

/// NaN counts as infinitely large.
using Objective = std::function<double(const std::vector<double>&)>;

enum class SearchMethod { direct, subplex, simplex, constrained };  ///< DIRECT-L, SBPLX, Nelder-Mead, COBYLA

/// One run of one method, and where it ends. A tolerance of 0 does not end it.
struct Minimisation {
    SearchMethod method = SearchMethod::subplex;
    Bounds bounds;
    std::vector<double> first_step;  ///< of each variable; empty: the method's own
    int evaluations = 0;
    double xtol_rel = 0, xtol_abs = 0, ftol_rel = 0, ftol_abs = 0;
    double stop_below = -HUGE_VAL;
    std::vector<Objective> constraints;  ///< g ≤ 0, of the constrained method
};

/// The best point that a run finds from `start`; one that ends by rounding or at its limit of work has found one too.
std::vector<double> minimum(const Minimisation& search, const Objective& objective, std::vector<double> start);

/// The next point at which a run from `start` asks for a value, given those at all points before; nothing where these
/// end it. A run costs nothing beside a value, and goes on here as often as it is asked: so its values may come from
/// elsewhere, and what it would ask next is known before they do.
std::optional<std::vector<double>> next_point(const Minimisation& search, const std::vector<double>& start,
                                              const std::vector<double>& values);

/// DIRECT-L over the whole box, without derivatives.
std::vector<double> global_minimum(const Objective& objective, const Bounds& bounds, int evaluations);

/// SBPLX from a start, with a first step as a share of the box.
std::vector<double> local_minimum(const Objective& objective, const Bounds& bounds, std::vector<double> start,
                                  double step, int evaluations);

/// COBYLA from a start under constraints g ≤ 0; the best point found that satisfies them to 1e-9, else the last one.
std::vector<double> constrained_minimum(const Objective& objective, const std::vector<Objective>& constraints,
                                        const Bounds& bounds, std::vector<double> start, double step, int evaluations);

}  // namespace stickslip
