#include "sweep/report/figures/map_figures.h"

#include "analysis/results/rests.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/nonlinear_findings.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// "10^{−12}" of 1e-12.
std::string power_of_ten(double value)
{
    const auto exponent = std::lround(std::log10(value));
    return std::string("10^{") + (exponent < 0 ? "−" : "") + std::to_string(std::abs(exponent)) + "}";
}

/// The share of a chart's area, axes as drawn, that has one of these regions.
double share_of(const Slice& slice, std::initializer_list<Region> regions)
{
    const auto shares = area_shares(slice.x, slice.y);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (std::find(regions.begin(), regions.end(), slice.region[i]) != regions.end()) sum += shares[i];
    return sum;
}

std::string held_words(const Slice& slice, Units units)
{
    return slice.held.empty() ? "" : " Held: " + held_text(slice.held, units) + ".";
}

Figure outcome_figure(Units units, const Slice& slice, const MapAnswer& answer, const MapReading& reading,
                      const char* id, std::string title, std::string how_to_read)
{
    FieldMap map;
    map.title = std::move(title);
    map.fixed = held_text(slice.held, units);
    map.units = units;
    map.x = slice.x;
    map.y = slice.y;
    map.name = reading.name;
    map.quantity = reading.quantity;
    map.values = cycle_values(reading, rests_of(slice.readings));
    map.none = none_reached(rests_of(slice.readings));
    double low = infinity, high = -infinity;
    std::size_t cycles = 0;
    for (const double v : map.values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v), ++cycles;
    map.scale = low > 0 && high > 30 * low ? FieldMap::Scale::log : FieldMap::Scale::linear;
    const auto share = percent(static_cast<double>(cycles) / static_cast<double>(reading.values.size()));
    const auto range = cycles ? span_text(low, high, reading.quantity, units) : std::string("nowhere");
    map.statement = share + " of the points end in a limit cycle.";
    for (const auto& curve : answer.curves)
        if (curve.kind == Curve::Kind::state_variable) map.lines.push_back({"", curve.x, curve.y, false, curve.kind});
    // where limit cycles end, located: the steps of the field beside it are those of the grid
    for (const auto& fold : answer.large.folds) map.lines.push_back({"", fold.x, fold.y, false, Curve::Kind::fold});
    map.design = answer.design;
    map.has_design = true;
    map.command = reproducing_command(slice);
    Figure figure;
    figure.id = chart_id(id, slice.x, slice.y);
    figure.finding = plain_text(reading.name) + " over " + slice.x.name + " and " + slice.y.name + ": " + range +
                     " on " + share + " of the points.";
    figure.caption = how_to_read + " Values lie " + range + ". " + followed_text(slice.readings) +
                     "; grey: " + map.none + "." + held_words(slice, units);
    figure.picture = std::move(map);
    return figure;
}

bool never_positive(const std::vector<double>& values)
{
    return std::none_of(values.begin(), values.end(), [](double v) { return v > 0; });
}

}  // namespace

std::string chart_id(const char* kind, const Axis& x, const Axis& y)
{
    std::string id = kind;
    for (const auto* axis : {&x, &y}) {
        id += '-';
        for (const char c : axis->path.substr(axis->path.rfind('.') + 1))
            id += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
    }
    return id;
}

std::string reproducing_command(const Slice& slice, const std::string& depth, const std::string& up)
{
    const auto posed = [](const Axis& axis) { return axis.path.starts_with("pose."); };
    const bool in_robot = posed(slice.x) || posed(slice.y) ||
                          std::ranges::any_of(slice.held, [&](const Held& held) { return posed(held.axis); });
    std::string command = std::string("stickslip simulate ") + (in_robot ? "spec.toml" : "joint.toml") + " --set " +
                          slice.x.path + "={x} --set " + slice.y.path + "={y}";
    for (const auto& h : slice.held)
        command += " --set " + h.axis.path + "=" +
                   (h.axis.path == depth ? std::string("{depth}")
                    : h.axis.path == up  ? std::string("{up}")
                                         : fmt::format("{}", h.value));
    return command + " -o motion";
}

StabilityMap stability_map(Units units, const Slice& slice, const MapAnswer& answer)
{
    StabilityMap map;
    map.units = units;
    map.title = "Stability of sliding over (" + slice.x.symbol + ", " + slice.y.symbol + ")";
    map.fixed = held_text(slice.held, map.units);
    map.x = slice.x;
    map.y = slice.y;
    map.abscissa = slice.abscissa;
    map.region = slice.region;
    map.disagreement = share_of(slice, {Region::memory_only, Region::velocity_only});
    map.undecided = share_of(slice, {Region::undecided});
    map.curves = answer.curves;
    map.curves.insert(map.curves.end(), answer.large.folds.begin(), answer.large.folds.end());
    map.readings = slice.readings;
    map.depth = slice.depth;
    map.layers = slice.layers;
    for (const auto& h : slice.held)
        if (h.axis.path == slice.depth.path) map.depth_value = h.value;
    for (std::size_t i = 0; i < map.layers.size(); ++i) map.layers[i].curves = answer.layer_curves[i];
    map.has_design = true;
    map.design = answer.design;
    map.command = reproducing_command(slice, slice.depth.path);
    map.motions = answer.motions;
    return map;
}

namespace {

/// On the chart as printed, or on one that its slider reaches.
bool has_curve(const StabilityMap& map, Curve::Kind kind)
{
    const auto among = [kind](const std::vector<Curve>& curves) {
        return std::ranges::any_of(curves, [kind](const Curve& c) { return c.kind == kind && !c.x.empty(); });
    };
    return among(map.curves) || std::ranges::any_of(map.layers, [&](const auto& layer) { return among(layer.curves); });
}

std::string pens_text(const StabilityMap& map)
{
    std::string text;
    if (has_curve(map, Curve::Kind::state_variable)) text += "Solid: boundary with memory (state-variable friction). ";
    if (has_curve(map, Curve::Kind::velocity_only))
        text += "Dashed: boundary of the velocity-only model of the same friction. ";
    return text;
}

std::string located_text(const StabilityMap& map, const MapAnswer& answer)
{
    const bool memory = has_curve(map, Curve::Kind::state_variable), other = has_curve(map, Curve::Kind::velocity_only);
    const std::string subject = memory && other ? "Both curves are" : "The boundary is";
    return (memory || other ? subject + " located to a relative bracket of " + power_of_ten(answer.precision) +
                                  ", not contoured from the grid"
                            : "No boundary was found on this chart") +
           "; the search does not exclude a closed piece smaller than 1/" + std::to_string(answer.mesh) +
           " of an axis.";
}

}  // namespace

Figure map_figure(Units units, const Slice& slice, const MapAnswer& answer, bool design_rests)
{
    Figure figure;
    auto map = stability_map(units, slice, answer);
    const double needless_share = share_of(slice, {Region::memory_only});
    const double missed_share = share_of(slice, {Region::velocity_only});
    const auto needless = percent(needless_share), missed = percent(missed_share);
    const auto bistable = share_of(slice, {Region::bistable});
    figure.id = chart_id("map", slice.x, slice.y);
    figure.finding = "Stability map over " + slice.x.name + " and " + slice.y.name + ". Sliding is smooth on " +
                     percent(share_of(slice, {Region::stable, Region::memory_only})) + " of the chart; on " + needless +
                     " of it only the model with memory predicts this, and on " + missed +
                     " the velocity-only model wrongly predicts smooth sliding. " +
                     (bistable > 0 ? percent(bistable) + " is bistable. " : "") +
                     design_point_text(map.design.region, map.design.spectral_abscissa, design_rests);
    figure.caption =
        "How to read it: blue decays, red grows (largest real part of the spectrum, with memory). " + pens_text(map);
    if (needless_share > 0)
        figure.caption += "Hatched in gold, " + needless +
                          " of the chart: smooth, though the velocity-only model predicts stick-slip. ";
    if (missed_share > 0)
        figure.caption += "Hatched crosswise, " + missed +
                          " of the chart: not smooth, though the velocity-only model predicts smooth sliding. ";
    figure.caption += located_text(map, answer) + held_words(slice, units);
    if (std::any_of(map.curves.begin(), map.curves.end(),
                    [](const Curve& c) { return c.kind == Curve::Kind::ideal_loop; }))
        figure.caption +=
            " Dotted: the boundary with memory under the paper's ideal loop, without sampling, dead time, "
            "lag, filter and integral.";
    if (const auto text = large_disturbances_text(slice, answer.large, units); !text.empty())
        figure.caption += " " + text;
    figure.picture = std::move(map);
    return figure;
}

std::vector<Figure> outcome_figures(Units units, const Slice& slice, const MapAnswer& answer)
{
    std::vector<Figure> figures;
    for (const auto& reading : slice.readings) {
        const auto values = cycle_values(reading, rests_of(slice.readings));
        if (std::ranges::none_of(values, [](double v) { return std::isfinite(v); })) continue;
        if (reading.column == "stick_fraction" && never_positive(values)) {
            if (!figures.empty()) figures.back().caption += " No cycle sticks: none falls below a hundredth of V_{0}.";
            continue;
        }
        if (reading.column == "amplitude")
            figures.push_back(outcome_figure(units, slice, answer, reading, "amplitude", "Amplitude of the limit cycle",
                                             "Half the peak-to-peak position."));
        else if (reading.column == "period")
            figures.push_back(outcome_figure(units, slice, answer, reading, "period", "Period of the limit cycle",
                                             "Duration of one limit cycle."));
        else if (reading.column == "stick_fraction")
            figures.push_back(outcome_figure(units, slice, answer, reading, "rest",
                                             "Share of the period spent sticking",
                                             "Share of each cycle at rest or below a hundredth of V_{0}."));
    }
    return figures;
}

}  // namespace stickslip
