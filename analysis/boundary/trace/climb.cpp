#include "analysis/boundary/trace/climb.h"

#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <limits>

namespace stickslip {
namespace {

constexpr int climb_evaluations = 60;
constexpr double climb_precision = 1e-3;  ///< of the reach, where the search ends if it stays positive

std::vector<double> lowest(const Objective& measure, std::vector<double> start, const Bounds& bounds)
{
    const double width = bounds.high[0] - bounds.low[0];
    Minimisation search{SearchMethod::subplex, bounds, std::vector<double>(start.size(), 0.25 * width),
                        climb_evaluations};
    search.xtol_abs = climb_precision * width;
    search.stop_below = -1e-300;
    return minimum(search, measure, std::move(start));
}

}  // namespace

Climb climb_to_zero(const std::function<double(UnitPoint)>& measure, UnitPoint start, double reach)
{
    const auto low = [&](double u) { return std::max(0.0, u - reach); };
    const auto high = [&](double u) { return std::min(1.0, u + reach); };
    Climb best{start, std::numeric_limits<double>::infinity()};
    lowest(
        [&](const std::vector<double>& x) {
            const UnitPoint p{x[0], x[1]};
            const double value = measure(p);
            if (value < best.value) best = {p, value};
            return value;
        },
        {start.u, start.v}, {{low(start.u), low(start.v)}, {high(start.u), high(start.v)}});
    return best;
}

double climb_to_zero(const std::function<double(double)>& measure, double start, double low, double high)
{
    return lowest([&](const std::vector<double>& x) { return measure(x[0]); }, {start}, {{low}, {high}})[0];
}

}  // namespace stickslip
