#include "sweep/report/figures/multiples.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr std::size_t along_one = 6, along_two = 4, rows_of_two = 3;  // panels
constexpr std::size_t panel_columns = 81, panel_rows = 61;            // nodes
constexpr int panel_mesh = 32;

/// Places spread evenly over an axis, both ends among them; the one nearest to `own` moves there.
std::vector<std::size_t> places(std::size_t size, std::size_t most, std::optional<std::size_t> own)
{
    const std::size_t count = std::min(size, most);
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < count; ++i)
        list.push_back(count == 1 ? own.value_or(0) : (i * (size - 1) + (count - 1) / 2) / (count - 1));
    if (own) {
        const auto distance = [&](std::size_t p) { return p > *own ? p - *own : *own - p; };
        *std::min_element(list.begin(), list.end(), [&](auto a, auto b) { return distance(a) < distance(b); }) = *own;
    }
    return list;
}

Axis chosen(const Axis& axis, const std::vector<std::size_t>& at)
{
    Axis part = axis;
    part.values.clear();
    for (const auto i : at) part.values.push_back(axis.values[i]);
    return part;
}

double smooth_share(const StabilityPanels& panels, const StabilityPanel& panel)
{
    const auto shares = area_shares(panels.x, panels.y);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (panel.region[i] == Region::stable || panel.region[i] == Region::memory_only) sum += shares[i];
    return sum;
}

/// "Smooth sliding covers 35 % of the map at V_{0} = 10 µm/s and 100 % at V_{0} = 0.1 m/s."
std::string finding(const StabilityPanels& panels)
{
    const std::size_t columns = panels.across.values.size(), row = panels.own / columns * columns;
    const auto words = [&](const StabilityPanel& panel) {
        return percent(smooth_share(panels, panel)) + " of the map at " + panels.across.symbol + " = " +
               with_unit(panel.across, panels.across.quantity, panels.motion);
    };
    return "Smooth sliding covers " + words(panels.panels[row]) + " and " + words(panels.panels[row + columns - 1]) +
           (panels.up.name.empty() ? std::string()
                                   : ", both at " + panels.up.symbol + " = " +
                                         with_unit(panels.panels[row].up, panels.up.quantity, panels.motion)) +
           ".";
}

}  // namespace

std::size_t further_axis(const std::vector<Axis>& axes, std::initializer_list<std::size_t> taken)
{
    std::size_t found = axes.size();
    for (std::size_t i = axes.size(); i-- > 0;)
        if (std::find(taken.begin(), taken.end(), i) == taken.end() && axes[i].values.size() > 1 &&
            (found == axes.size() || axes[found].path != "control.V0"))
            found = i;
    return found;
}

std::optional<Multiples> read_multiples(const ResultsFile& results, std::size_t x, std::size_t y,
                                        std::span<const std::size_t> own)
{
    const auto& axes = results.axes();
    const std::size_t z = further_axis(axes, {x, y});
    if (z == axes.size()) return std::nullopt;
    const std::size_t w = further_axis(axes, {x, y, z});
    const bool two = w < axes.size();

    Multiples multiples;
    StabilityPanels& panels = multiples.panels;
    for (std::size_t i = 0; i < axes.size(); ++i)
        if (i != x && i != y && i != z && i != w) multiples.held.push_back({axes[i], axes[i].values[own[i]]});
    const auto columns = places(axes[x].values.size(), panel_columns, std::nullopt);
    const auto rows = places(axes[y].values.size(), panel_rows, std::nullopt);
    const auto across = places(axes[z].values.size(), two ? along_two : along_one, own[z]);
    const auto up = two ? places(axes[w].values.size(), rows_of_two, own[w]) : std::vector<std::size_t>{0};
    panels.x = chosen(axes[x], columns);
    panels.y = chosen(axes[y], rows);
    panels.across = chosen(axes[z], across);
    if (two) panels.up = chosen(axes[w], up);

    std::vector<std::size_t> at(own.begin(), own.end());
    for (const std::size_t b : up)
        for (const std::size_t a : across) {
            at[z] = a;
            if (two) at[w] = b;
            if (a == own[z] && (!two || b == own[w])) panels.own = panels.panels.size();
            const auto field = results.plane("spectral_abscissa", x, y, at);
            const auto codes = results.code_plane("region", x, y, at);
            StabilityPanel panel{axes[z].values[a], two ? axes[w].values[b] : 0, {}, {}, {}};
            for (const std::size_t j : rows)
                for (const std::size_t i : columns) {
                    panel.abscissa.push_back(field[j * axes[x].values.size() + i]);
                    panel.region.push_back(static_cast<Region>(codes[j * axes[x].values.size() + i]));
                }
            panels.panels.push_back(std::move(panel));
        }
    return multiples;
}

Figure multiples_figure(const Joint& design, const Multiples& multiples)
{
    StabilityPanels panels = multiples.panels;
    panels.motion = design.mechanism.motion;
    panels.title =
        "The same map along " + panels.across.symbol + (panels.up.name.empty() ? "" : " and " + panels.up.symbol);
    panels.fixed = held_text(multiples.held, panels.motion);
    const auto held_at = [&](const StabilityPanel& panel) {
        std::vector<Held> held = multiples.held;
        held.push_back({panels.across, panel.across});
        if (!panels.up.name.empty()) held.push_back({panels.up, panel.up});
        return held;
    };
    tbb::parallel_for(std::size_t{0}, panels.panels.size(), [&](std::size_t i) {
        auto& panel = panels.panels[i];
        panel.curves = chart_boundaries(joint_at(design, held_at(panel)), panels.x, panels.y, panel_mesh);
    });
    const Slice slice{panels.x, panels.y, held_at(panels.panels[panels.own]), {}, {}};
    panels.design = design_point(design, slice);
    panels.has_design = true;
    panels.command = reproducing_command(slice, panels.across.path, panels.up.path);

    Figure figure;
    figure.id = chart_id("panels", panels.x, panels.y);
    figure.finding = "Small multiples of the stability map over " + panels.x.name + " and " + panels.y.name +
                     " along " + panels.across.name + (panels.up.name.empty() ? "" : " and " + panels.up.name) + ". " +
                     finding(panels);
    figure.caption =
        "How to read it: each panel is the stability map at another value, in bold the one nearest to the "
        "design; colours, textures and boundaries mean the same everywhere. " +
        finding(panels);
    figure.picture = std::move(panels);
    return figure;
}

}  // namespace stickslip
