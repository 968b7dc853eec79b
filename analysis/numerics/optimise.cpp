#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

namespace stickslip {
namespace {

constexpr double never = 1e300;  ///< what NaN and infinity count as: the methods compute with it
constexpr double slack = 1e-9;   ///< of a constraint
constexpr double precision = 1e-9;

/// A function for NLopt, which loses what is thrown inside: it is kept until NLopt has returned.
struct Call {
    const Objective* function;
    std::exception_ptr* thrown;
};

double call(const std::vector<double>& x, std::vector<double>&, void* data)
{
    const auto& call = *static_cast<const Call*>(data);
    try {
        const double value = (*call.function)(x);
        return std::isnan(value) ? never : std::clamp(value, -never, never);
    } catch (...) {
        *call.thrown = std::current_exception();
        throw nlopt::forced_stop();
    }
}

nlopt::algorithm algorithm_of(SearchMethod method)
{
    switch (method) {
        case SearchMethod::direct:
            return nlopt::GN_DIRECT_L;
        case SearchMethod::simplex:
            return nlopt::LN_NELDERMEAD;
        case SearchMethod::constrained:
            return nlopt::LN_COBYLA;
        case SearchMethod::subplex:
            break;
    }
    return nlopt::LN_SBPLX;
}

std::vector<double> steps(const Bounds& bounds, double share)
{
    std::vector<double> step;
    for (std::size_t i = 0; i < bounds.low.size(); ++i) step.push_back(share * (bounds.high[i] - bounds.low[i]));
    return step;
}

}  // namespace

std::vector<double> minimum(const Minimisation& problem, const Objective& objective, std::vector<double> x)
{
    const auto& bounds = problem.bounds;
    nlopt::opt search(algorithm_of(problem.method), static_cast<unsigned>(x.size()));
    std::exception_ptr thrown;
    std::vector<Call> functions{{&objective, &thrown}};
    for (const auto& g : problem.constraints) functions.push_back({&g, &thrown});
    search.set_min_objective(call, &functions[0]);
    for (std::size_t i = 1; i < functions.size(); ++i) search.add_inequality_constraint(call, &functions[i], slack / 2);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::clamp(x[i], bounds.low[i], bounds.high[i]);
    search.set_lower_bounds(bounds.low);
    search.set_upper_bounds(bounds.high);
    if (!problem.first_step.empty()) search.set_initial_step(problem.first_step);
    search.set_maxeval(problem.evaluations);
    search.set_xtol_rel(problem.xtol_rel);
    search.set_xtol_abs(problem.xtol_abs);
    search.set_ftol_rel(problem.ftol_rel);
    search.set_ftol_abs(problem.ftol_abs);
    search.set_stopval(problem.stop_below);
    double value = 0;
    try {
        search.optimize(x, value);
    } catch (const nlopt::roundoff_limited&) {
        // the point reached so far is in x
    } catch (const nlopt::forced_stop&) {
        std::rethrow_exception(thrown);
    }
    return x;
}

std::optional<std::vector<double>> next_point(const Minimisation& search, const std::vector<double>& start,
                                              const std::vector<double>& values)
{
    struct Asks {
        std::vector<double> where;
    };
    std::size_t known = 0;
    const Objective told = [&](const std::vector<double>& x) {
        if (known == values.size()) throw Asks{x};
        return values[known++];
    };
    try {
        minimum(search, told, start);
    } catch (const Asks& asks) {
        return asks.where;
    }
    return std::nullopt;
}

std::vector<double> global_minimum(const Objective& objective, const Bounds& bounds, int evaluations)
{
    std::vector<double> middle;
    for (std::size_t i = 0; i < bounds.low.size(); ++i) middle.push_back((bounds.low[i] + bounds.high[i]) / 2);
    Minimisation search{SearchMethod::direct, bounds, {}, evaluations};
    search.xtol_rel = precision;
    return minimum(search, objective, middle);
}

std::vector<double> local_minimum(const Objective& objective, const Bounds& bounds, std::vector<double> start,
                                  double step, int evaluations)
{
    Minimisation search{SearchMethod::subplex, bounds, steps(bounds, step), evaluations};
    search.xtol_rel = precision;
    return minimum(search, objective, std::move(start));
}

std::vector<double> constrained_minimum(const Objective& objective, const std::vector<Objective>& constraints,
                                        const Bounds& bounds, std::vector<double> start, double step, int evaluations)
{
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
    Minimisation search{SearchMethod::constrained, bounds, steps(bounds, step), evaluations};
    search.xtol_rel = precision;
    search.constraints = constraints;
    const auto last = minimum(search, watched, std::move(start));
    return best.empty() ? last : best;
}

}  // namespace stickslip
