#include "sweep/report/figures/multiples.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"

namespace stickslip {
namespace {

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
               with_unit(panel.across, panels.across.quantity, panels.units);
    };
    return "Smooth sliding covers " + words(panels.panels[row]) + " and " + words(panels.panels[row + columns - 1]) +
           (panels.up.name.empty() ? std::string()
                                   : ", both at " + panels.up.symbol + " = " +
                                         with_unit(panels.panels[row].up, panels.up.quantity, panels.units)) +
           ".";
}

}  // namespace

Figure multiples_figure(const Multiples& multiples, const PanelsAnswer& answer, Units units)
{
    StabilityPanels panels = multiples.panels;
    panels.units = units;
    panels.title =
        "The same map along " + panels.across.symbol + (panels.up.name.empty() ? "" : " and " + panels.up.symbol);
    panels.fixed = held_text(multiples.held, panels.units);
    for (std::size_t i = 0; i < panels.panels.size(); ++i) panels.panels[i].curves = answer.curves[i];
    const Slice slice{panels.x, panels.y, held_in_panel(multiples, panels.panels[panels.own]), {}, {}};
    panels.design = answer.design;
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
