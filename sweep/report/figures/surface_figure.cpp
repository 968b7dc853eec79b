// The critical gain over two parameters, in space.
#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// What the surface's missing places mean, in a sentence: no single critical gain has three causes.
std::string where_missing(const GainSurface& surface)
{
    std::string text;
    if (surface.always > 0) text += " Every positive gain is stable at " + percent(surface.always) + " of the points.";
    if (surface.never > 0) text += " No gain is stable at " + percent(surface.never) + ".";
    if (surface.windows > 0) text += " Windows of gains are stable at " + percent(surface.windows) + ".";
    return text.empty() ? text : " Where the surface is missing:" + text;
}

}  // namespace

Figure surface_figure(const GainSurface& found, Units units)
{
    CriticalGainSurface surface;
    surface.title = "Critical position gain k_{cr}(" + found.x.symbol + ", " + found.y.symbol + ")";
    surface.units = units;
    surface.x = found.x;
    surface.y = found.y;
    surface.z_name = "critical position gain";
    surface.z_symbol = "k_{cr}";
    surface.z = found.k_cr;
    double low = infinity, high = -infinity;
    for (const double z : surface.z)
        if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
    const std::string range = low <= high ? span_text(low, high, Quantity::position_gain, units, from_to)
                                          : std::string("nowhere on this range");
    Figure figure;
    figure.id = chart_id("surface", found.x, found.y);
    figure.finding =
        "Surface of the critical position gain over " + found.x.name + " and " + found.y.name + ", " + range;
    figure.caption = "Least position gain for stable sliding, " + range + "." + where_missing(found);
    figure.picture = std::move(surface);
    return figure;
}

}  // namespace stickslip
