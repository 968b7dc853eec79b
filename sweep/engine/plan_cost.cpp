#include "sweep/engine/plan_cost.h"

#include "sweep/engine/row_format.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <span>

namespace stickslip {
namespace {

struct Unit {
    double size;
    const char* name;
};

/// In the largest unit of which there is a whole one, rounded up to a tenth: 0.0 s would promise too much.
std::string in_units(double value, std::span<const Unit> units)
{
    auto unit = units.begin();
    while (std::next(unit) != units.end() && value >= std::next(unit)->size) ++unit;
    return fmt::format("{:.12g} {}", std::ceil(value / unit->size * 10) / 10, unit->name);
}

}  // namespace

PlanCost plan_cost(double points, bool nonlinear)
{
    return {points * static_cast<double>(RowFormat(nonlinear).bytes_per_point()),
            points * (nonlinear ? nonlinear_point_cost : linear_point_cost)};
}

std::string bytes_text(double bytes)
{
    constexpr Unit units[] = {{1e6, "MB"}, {1e9, "GB"}, {1e12, "TB"}, {1e15, "PB"}, {1e18, "EB"}};
    return in_units(bytes, units);
}

std::string describe(const PlanCost& cost)
{
    constexpr Unit units[] = {{1, "seconds"}, {60, "minutes"}, {3600, "hours"}, {86400, "days"}, {31557600, "years"}};
    return bytes_text(cost.bytes) + " of results and " + in_units(cost.seconds, units) + " of one core";
}

}  // namespace stickslip
