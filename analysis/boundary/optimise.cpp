#include "analysis/boundary/optimise.h"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

namespace stickslip {
namespace {

constexpr double never = 1e300;  ///< what NaN and infinity count as: the methods compute with it

double call(const std::vector<double>& x, std::vector<double>&, void* data)
{
    const double value = (*static_cast<const Objective*>(data))(x);
    return std::isfinite(value) ? value : never;
}

/// A search that ends by rounding or at its limit of work has still found its best point.
std::vector<double> run(nlopt::opt& search, const Bounds& bounds, std::vector<double> x, int evaluations)
{
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::clamp(x[i], bounds.low[i], bounds.high[i]);
    search.set_lower_bounds(bounds.low);
    search.set_upper_bounds(bounds.high);
    search.set_maxeval(evaluations);
    search.set_xtol_rel(1e-9);
    double value = 0;
    try {
        search.optimize(x, value);
    } catch (const nlopt::roundoff_limited&) {
    }
    return x;
}

std::vector<double> steps(const Bounds& bounds, double share)
{
    std::vector<double> step;
    for (std::size_t i = 0; i < bounds.low.size(); ++i) step.push_back(share * (bounds.high[i] - bounds.low[i]));
    return step;
}

}  // namespace

std::vector<double> global_minimum(const Objective& objective, const Bounds& bounds, int evaluations)
{
    nlopt::opt search(nlopt::GN_DIRECT_L, static_cast<unsigned>(bounds.low.size()));
    search.set_min_objective(call, const_cast<Objective*>(&objective));
    std::vector<double> middle;
    for (std::size_t i = 0; i < bounds.low.size(); ++i) middle.push_back((bounds.low[i] + bounds.high[i]) / 2);
    return run(search, bounds, middle, evaluations);
}

std::vector<double> local_minimum(const Objective& objective, const Bounds& bounds, std::vector<double> start,
                                  double step, int evaluations)
{
    nlopt::opt search(nlopt::LN_SBPLX, static_cast<unsigned>(start.size()));
    search.set_min_objective(call, const_cast<Objective*>(&objective));
    search.set_initial_step(steps(bounds, step));
    return run(search, bounds, std::move(start), evaluations);
}

std::vector<double> constrained_minimum(const Objective& objective, const std::vector<Objective>& constraints,
                                        const Bounds& bounds, std::vector<double> start, double step, int evaluations)
{
    constexpr double slack = 1e-9;
    std::vector<double> best;
    double least = never;
    const Objective watched = [&](const std::vector<double>& x) {
        const double value = objective(x);
        if (!(value < least)) return value;
        for (const auto& g : constraints)
            if (!(g(x) <= slack)) return value;
        least = value, best = x;
        return value;
    };
    nlopt::opt search(nlopt::LN_COBYLA, static_cast<unsigned>(start.size()));
    search.set_min_objective(call, const_cast<Objective*>(&watched));
    for (const auto& g : constraints) search.add_inequality_constraint(call, const_cast<Objective*>(&g), slack / 2);
    search.set_initial_step(steps(bounds, step));
    const auto last = run(search, bounds, std::move(start), evaluations);
    return best.empty() ? last : best;
}

}  // namespace stickslip
