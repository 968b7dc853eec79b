#include "sweep/report/figures/nonlinear_findings.h"

#include "analysis/results/rests.h"
#include "analysis/results/text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

std::string extent_text(const Axis& axis, const Extent& extent, Units units)
{
    return axis.symbol + " = " + range_text(extent.low, extent.high, axis.quantity, units, low_to_high);
}

std::string reach_text(const Slice& slice, const FoldReach& reach, Units units)
{
    if (std::isnan(reach.ratio)) return "";
    const Axis& other = slice.x.path == gain_path ? slice.y : slice.x;
    return " The fold of limit cycles, beyond which none is left, lies up to " + plain_number(reach.ratio) +
           " times the critical gain away: at " + other.symbol + " = " + with_unit(reach.at, other.quantity, units) +
           " the linear theory requires k_{p} > " + with_unit(reach.k_cr, Quantity::position_gain, units) +
           ", freedom from stick-slip for " + with_unit(reach.k_p, Quantity::position_gain, units) + ".";
}

/// The share of the chart, axes as drawn, where a larger disturbance leaves the joint at rest for good.
double bistable_at_rest(const Slice& slice)
{
    const auto rests = rests_of(slice.readings);
    if (rests.empty()) return 0;
    const auto shares = area_shares(slice.x, slice.y);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (rests[i] && slice.region[i] == Region::bistable) sum += shares[i];
    return sum;
}

}  // namespace

std::string large_disturbances_text(const Slice& slice, const LargeDisturbances& found, Units units)
{
    if (found.bistable == 0) return "";
    const double still = bistable_at_rest(slice);
    const std::string end = still > found.bistable * (1 - 1e-9) ? "leaves the joint at rest for good"
                            : still == 0                        ? "ends in a limit cycle"
                                                                : "ends in a limit cycle, or on " + percent(still) +
                                               " of the chart leaves the joint at rest for good";
    return "Errors of the linear chart: on " + percent(found.bistable) + " of the chart, " +
           percent(found.of_linearly_stable) +
           " of what it calls stable, small disturbances decay while a start from near rest " + end +
           " (bistable). These points lie within " + extent_text(slice.x, found.x, units) + " and " +
           extent_text(slice.y, found.y, units) + "." + reach_text(slice, found.reach, units) +
           (found.without_boundary ? " Some of them lie where the linear theory sees no boundary along k_{p} at all."
                                   : "");
}

std::vector<double> cycle_values(const MapReading& reading, const std::vector<bool>& rests)
{
    auto values = reading.values;
    for (std::size_t i = 0; i < rests.size(); ++i)
        if (rests[i]) values[i] = missing;
    return values;
}

std::string none_reached(const std::vector<bool>& rests)
{
    const auto still = std::ranges::count(rests, true);
    if (still == 0) return "no limit cycle was reached";
    return "no limit cycle was reached, and on " +
           percent(static_cast<double>(still) / static_cast<double>(rests.size())) +
           " of the points the joint ends at rest for good";
}

std::string followed_text(std::span<const MapReading> readings)
{
    const std::string followed =
        " started close to steady sliding and, where that decays, from near rest, and followed to its end";
    const auto errors = std::find_if(readings.begin(), readings.end(),
                                     [](const auto& reading) { return reading.column == "interpolation_error"; });
    if (errors == readings.end()) return "Every point was" + followed;
    double largest = 0;
    std::size_t interpolated = 0;
    for (const double error : errors->values)
        if (error > 0) largest = std::max(largest, error), ++interpolated;
    if (interpolated == 0) return "Every point was" + followed;
    const double share = static_cast<double>(interpolated) / static_cast<double>(errors->values.size());
    return "Of the points " + percent(1 - share) + ", among them both neighbours wherever outcomes differ, were" +
           followed + "; " + percent(share) + " are interpolated between them, off by at most " +
           plain_number(100 * largest) + " % where points between were followed to check them";
}

}  // namespace stickslip
