#include "sweep/files/plan_size.h"

#include "sweep/files/toml_input.h"

#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace stickslip::files {
namespace {

std::string with_unit(double value, std::initializer_list<std::pair<double, const char*>> units)
{
    const auto last = std::prev(units.end());
    for (auto u = units.begin(); u != units.end(); ++u) {
        if (value >= 1000 * u->first && u != last) continue;
        std::string text = number_text(std::round(value / u->first * 10) / 10);
        return text + " " + u->second;
    }
    return "";
}

std::string duration_text(double seconds)
{
    constexpr double minute = 60, hour = 3600, day = 86400, year = 365.25 * day;
    if (seconds > year) return number_text(std::round(seconds / year * 10) / 10) + " years";
    if (seconds > day) return number_text(std::round(seconds / day * 10) / 10) + " days";
    if (seconds > hour) return number_text(std::round(seconds / hour * 10) / 10) + " hours";
    return number_text(std::ceil(seconds / minute)) + " minutes";
}

}  // namespace

std::string plan_size_text(double points, const PlanLimits& limits)
{
    const std::string bytes =
        with_unit(points * limits.bytes_per_row, {{1e9, "GB"}, {1e12, "TB"}, {1e15, "PB"}, {1e18, "EB"}});
    return "make " + number_text(points) + " points (about " + bytes + " of results and " +
           duration_text(points / limits.points_per_second) + " of computing), allowed are at most " +
           number_text(static_cast<double>(limits.points));
}

}  // namespace stickslip::files
