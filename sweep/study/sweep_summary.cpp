#include "sweep/study/sweep_summary.h"

#include "analysis/joint/parameters.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr std::size_t most_charts = 6;

std::size_t index_of(const std::vector<Axis>& axes, const std::string& path)
{
    return static_cast<std::size_t>(
        std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return a.path == path; }) - axes.begin());
}

bool has_axis(const Spec& spec, const char* path)
{
    return index_of(spec.axes, path) < spec.axes.size();
}

}  // namespace

void choose_charts(Spec& spec)
{
    auto& report = spec.report;
    if (report.charts.empty() && spec.axes.size() > 1) {
        const std::size_t gain = index_of(spec.axes, "control.k_p");
        const auto& x = spec.axes[gain < spec.axes.size() ? gain : 0];
        for (const auto& y : spec.axes)
            if (y.path != x.path && report.charts.size() < most_charts) report.charts.push_back({x.path, y.path});
    }
    if (report.surfaces.empty() && has_axis(spec, "control.k_v") && has_axis(spec, "control.V0"))
        report.surfaces.push_back({"control.k_v", "control.V0"});
}

namespace {

std::vector<Region> regions_of(const std::vector<std::uint8_t>& codes)
{
    std::vector<Region> regions;
    for (const auto code : codes) regions.push_back(static_cast<Region>(code));
    return regions;
}

/// A chart of a large sweep gets fewer layers, so that a page stays a page.
constexpr std::size_t most_layers = 21, most_layer_points = 250'000;

/// Evenly spread places on an axis, `own` among them.
std::vector<std::size_t> spread(std::size_t size, std::size_t own, std::size_t most)
{
    const std::size_t step = (size + most - 1) / most;
    std::vector<std::size_t> places;
    for (std::size_t i = own % step; i < size; i += step) places.push_back(i);
    return places;
}

void add_layers(Slice& slice, const std::vector<Axis>& axes, const ResultsFile& results, std::size_t x, std::size_t y,
                std::vector<std::size_t> at)
{
    const std::size_t z = further_axis(axes, {x, y});
    const std::size_t most = std::min(most_layers, most_layer_points / std::max<std::size_t>(1, slice.abscissa.size()));
    if (z == axes.size() || most < 3) return;
    slice.depth = axes[z];
    for (const auto place : spread(axes[z].values.size(), at[z], most)) {
        at[z] = place;
        slice.layers.push_back({axes[z].values[place],
                                results.plane("spectral_abscissa", x, y, at),
                                regions_of(results.code_plane("region", x, y, at)),
                                {}});
    }
}

}  // namespace

SweepSummary summarise(const Spec& spec, const ResultsFile& results)
{
    SweepSummary summary;
    summary.points = results.points();
    const auto& axes = spec.axes;
    Joint joint = design_joint(spec);
    std::vector<std::size_t> at;
    for (const auto& axis : axes) at.push_back(nearest_index(axis, *find_parameter(joint, axis.path)));
    const auto held_besides = [&](std::size_t x, std::size_t y) {
        std::vector<Held> held;
        for (std::size_t i = 0; i < axes.size(); ++i)
            if (i != x && i != y) held.push_back({axes[i], axes[i].values[at[i]]});
        return held;
    };
    for (const auto& [x_path, y_path] : spec.report.charts) {
        const std::size_t x = index_of(axes, x_path), y = index_of(axes, y_path);
        Slice slice{axes[x], axes[y], held_besides(x, y), results.plane("spectral_abscissa", x, y, at),
                    regions_of(results.code_plane("region", x, y, at))};
        for (const auto& column : columns())
            if (column.nonlinear && column.number && results.has(column.name))
                slice.readings.push_back({std::string(column.long_name), column.quantity,
                                          results.plane(column.name, x, y, at), std::string(column.name)});
        add_layers(slice, axes, results, x, y, at);
        if (summary.slices.empty()) summary.multiples = read_multiples(results, x, y, at);
        summary.slices.push_back(std::move(slice));
    }
    if (axes.size() == 1) {
        Profile profile{axes[0], held_besides(0, 0), results.line("spectral_abscissa", 0, at), {}};
        for (const auto& column : columns())
            if (column.nonlinear && column.number && results.has(column.name))
                profile.readings.push_back({std::string(column.long_name), column.quantity,
                                            results.line(column.name, 0, at), std::string(column.name)});
        summary.profiles.push_back(std::move(profile));
    }
    if (results.has("path")) {
        const auto paths = results.count_codes("path");
        constexpr auto interpolation = static_cast<std::size_t>(DecisionPath::interpolation);
        if (paths.size() > interpolation) summary.interpolated = paths[interpolation];
    }
    if (results.has("outcome")) {
        const auto outcomes = results.count_codes("outcome");
        constexpr auto held = static_cast<std::size_t>(Outcome::held);
        if (outcomes.size() > held) summary.held = outcomes[held];
    }
    const auto reasons = results.count_codes("reason");
    for (std::size_t code = 1; code < reasons.size(); ++code) {
        if (reasons[code] == 0) continue;
        summary.undecided += reasons[code];
        summary.reasons.emplace_back(static_cast<Reason>(code), reasons[code]);
    }
    for (const char* name : {"source", "build", "plan_id", "command"})
        summary.provenance.emplace_back(name, results.attribute(name));
    return summary;
}

}  // namespace stickslip
