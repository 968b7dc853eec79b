#include "sweep/study/panels.h"

#include "sweep/study/map_answer.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr std::size_t along_one = 6, along_two = 4, rows_of_two = 3;  // panels
constexpr std::size_t panel_columns = 81, panel_rows = 61;            // nodes

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

constexpr int panel_mesh = 32;

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

PanelsAnswer answer_panels(const Joint& design, const Multiples& multiples)
{
    const auto& panels = multiples.panels;
    PanelsAnswer answer;
    answer.curves.resize(panels.panels.size());
    tbb::parallel_for(std::size_t{0}, panels.panels.size(), [&](std::size_t i) {
        const auto held = held_in_panel(multiples, panels.panels[i]);
        answer.curves[i] = chart_boundaries(joint_at(design, held), panels.x, panels.y, panel_mesh);
    });
    const Slice own{panels.x, panels.y, held_in_panel(multiples, panels.panels[panels.own]), {}, {}};
    answer.design = design_point(design, own);
    return answer;
}

}  // namespace stickslip
