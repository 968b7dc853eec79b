#include "analysis/boundary/climb.h"

#include <algorithm>
#include <nlopt.hpp>

namespace stickslip {
namespace {

constexpr int climb_evaluations = 60;
constexpr double climb_precision = 1e-3;  ///< of the reach, where the search ends if it stays positive

using Measure = std::function<double(const std::vector<double>&)>;

double call(const std::vector<double>& x, std::vector<double>&, void* data)
{
    const double value = (*static_cast<const Measure*>(data))(x);
    return std::isnan(value) ? HUGE_VAL : value;
}

std::vector<double> lowest(const Measure& measure, std::vector<double> x, const std::vector<double>& low,
                           const std::vector<double>& high, double& value)
{
    nlopt::opt search(nlopt::LN_SBPLX, static_cast<unsigned>(x.size()));
    search.set_min_objective(call, const_cast<Measure*>(&measure));
    search.set_lower_bounds(low);
    search.set_upper_bounds(high);
    search.set_initial_step(0.25 * (high[0] - low[0]));
    search.set_xtol_abs(climb_precision * (high[0] - low[0]));
    search.set_stopval(-1e-300);
    search.set_maxeval(climb_evaluations);
    search.optimize(x, value);
    return x;
}

}  // namespace

Climb climb_to_zero(const std::function<double(UnitPoint)>& measure, UnitPoint start, double reach)
{
    const auto low = [&](double u) { return std::max(0.0, u - reach); };
    const auto high = [&](double u) { return std::min(1.0, u + reach); };
    Climb best;
    const auto x = lowest(
        [&](const std::vector<double>& p) {
            return measure({p[0], p[1]});
        },
        {start.u, start.v}, {low(start.u), low(start.v)}, {high(start.u), high(start.v)}, best.value);
    best.p = {x[0], x[1]};
    return best;
}

double climb_to_zero(const std::function<double(double)>& measure, double start, double low, double high)
{
    double value = 0;
    return lowest([&](const std::vector<double>& p) { return measure(p[0]); }, {start}, {low}, {high}, value)[0];
}

}  // namespace stickslip
