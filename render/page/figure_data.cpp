#include "render/page/figure_data.h"

#include "analysis/results/text.h"
#include "render/axes/scale.h"
#include "render/csv/csv.h"
#include "render/drawing/markup.h"
#include "render/page/json.h"
#include "render/page/layer_data.h"
#include "render/page/line_data.h"
#include "render/page/pack_arrays.h"
#include "render/pictures/regions.h"
#include "render/pictures/surface_rim.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

bool takes_prefix(Quantity quantity, Units units)
{
    return scaled_unit(1e3, quantity, units).text != unit_of(quantity, units);
}

std::size_t nearest(const Axis& axis, double value)
{
    const Scale scale = spanning(axis.values, axis.log);
    std::size_t best = 0;
    for (std::size_t i = 1; i < axis.values.size(); ++i)
        if (std::abs(scale.at(axis.values[i]) - scale.at(value)) <
            std::abs(scale.at(axis.values[best]) - scale.at(value)))
            best = i;
    return best;
}

/// `hides_zero`: a read-out leaves it out where it is 0.
std::string reading(std::string_view name, Quantity quantity, Units units, const std::vector<double>& values,
                    bool hides_zero = false)
{
    return JsonObject()
        .text("name", name)
        .text("unit", unit_of(quantity, units))
        .flag("prefix", takes_prefix(quantity, units))
        .flag("hides_zero", hides_zero)
        .text("values", pack_floats(values))
        .close();
}

struct GridPicture {
    const Axis &x, &y;
    Units units;
    std::string header;         ///< of its CSV file
    const DesignPoint* design;  ///< null: none, or beyond the chart
};

/// What every picture over a rectangular grid shares: where the data area lies, the axes, where a reader starts.
JsonObject grid_data(const GridPicture& grid, const RenderedFigure& rendered, const char* kind = "grid")
{
    const std::size_t column = grid.design ? nearest(grid.x, grid.design->x) : grid.x.values.size() / 2;
    const std::size_t row = grid.design ? nearest(grid.y, grid.design->y) : grid.y.values.size() / 2;
    JsonObject json;
    json.text("kind", kind)
        .text("header", grid.header)
        .numbers("start", {static_cast<double>(column), static_cast<double>(row)})
        .raw("x", axis_data(grid.x, grid.units))
        .raw("y", axis_data(grid.y, grid.units));
    if (rendered.plot.width > 0) json.raw("area", area_data(rendered.plot, rendered));
    return json;
}

std::string class_name(std::string_view name, std::string_view text)
{
    return JsonObject().text("name", name).text("text", text).close();
}

std::string region_classes(UnsmoothEnd unsmooth = UnsmoothEnd::stick_slip)
{
    std::vector<std::string> list;
    for (int i = 0; i <= static_cast<int>(Region::neutral); ++i)
        list.push_back(class_name(region_name(static_cast<Region>(i)), region_text(static_cast<Region>(i), unsmooth)));
    return json_array(list);
}

std::string data(const StabilityMap& map, const RenderedFigure& rendered)
{
    const DesignPoint* design = map.has_design && map.design.inside ? &map.design : nullptr;
    JsonObject json = grid_data({map.x, map.y, map.units, csv_header(map), design}, rendered);
    std::vector<std::string> readings{reading("max Re s", Quantity::rate, map.units, map.abscissa)};
    for (const auto& r : map.readings)
        readings.push_back(reading(r.name, r.quantity, map.units, r.values, r.column == "interpolation_error"));
    json.raw("readings", json_array(readings))
        .raw("classes", region_classes(unsmooth_end(map)))
        .text("class", pack(region_codes(map.region)));
    if (design) json.numbers("design", {map.design.x, map.design.y});
    if (!map.command.empty()) json.text("command", map.command);
    if (!map.layers.empty()) json.raw("depth", depth_data(map));
    if (!map.motions.empty()) json.raw("motions", motion_data(map));
    return json.close();
}

std::string data(const StabilityPanels& p, const RenderedFigure& rendered)
{
    const DesignPoint* design = p.has_design && p.design.inside ? &p.design : nullptr;
    JsonObject json = grid_data({p.x, p.y, p.units, csv_header(p), design}, rendered, "panels");
    std::vector<std::string> areas, places;
    for (const auto& area : rendered.panels) areas.push_back(area_data(area, rendered));
    std::vector<double> field;
    std::vector<Region> regions;
    for (const auto& panel : p.panels) {
        places.push_back(JsonObject().number("across", panel.across).number("up", panel.up).close());
        field.insert(field.end(), panel.abscissa.begin(), panel.abscissa.end());
        regions.insert(regions.end(), panel.region.begin(), panel.region.end());
    }
    json.raw("areas", json_array(areas))
        .raw("places", json_array(places))
        .number("own", static_cast<double>(p.own))
        .raw("readings", json_array({reading("max Re s", Quantity::rate, p.units, {})}))
        .text("field", pack_coarse(field))
        .raw("classes", region_classes())
        .text("class", pack(region_codes(regions)))
        .raw("across", axis_data(p.across, p.units));
    if (!p.up.name.empty()) json.raw("up", axis_data(p.up, p.units));
    if (!p.command.empty()) json.text("command", p.command);
    return json.close();
}

std::string data(const FieldMap& map, const RenderedFigure& rendered)
{
    const DesignPoint* design = map.has_design && map.design.inside ? &map.design : nullptr;
    JsonObject json = grid_data({map.x, map.y, map.units, csv_header(map), design}, rendered);
    if (map.classes.empty()) {
        json.raw("readings", json_array({reading(plain_text(map.name), map.quantity, map.units, map.values)}));
        if (!map.none.empty()) json.text("none", map.none);
    } else {
        std::vector<std::string> names;
        for (const auto& name : map.classes) names.push_back(class_name(plain_text(name), plain_text(name)));
        std::vector<std::uint8_t> codes(map.values.begin(), map.values.end());
        json.raw("readings", "[]").raw("classes", json_array(names)).text("class", pack(codes));
    }
    if (!map.command.empty()) json.text("command", map.command);
    return json.close();
}

std::string data(const CriticalGainSurface& surface, const RenderedFigure& rendered)
{
    RenderedFigure seen_from_aside = rendered;
    seen_from_aside.plot = {};  // no place of the picture is a place of the grid
    const auto rim = unresolved_rim(surface);
    const std::vector<double> undrawn(rim.begin(), rim.end());
    return grid_data({surface.x, surface.y, surface.units, csv_header(surface), nullptr}, seen_from_aside)
        .flag("surface", true)
        .raw("readings", json_array({reading(surface.z_name, surface.z_quantity, surface.units, surface.z)}))
        .numbers("undrawn", undrawn)
        .close();
}

std::string data(const DetailedChart& chart, const RenderedFigure& rendered)
{
    return chart_data(chart, rendered);
}

std::string data(const LineChart& chart, const RenderedFigure& rendered)
{
    return chart_data(detailed(chart), rendered);
}

/// Nothing behind the picture.
std::string data(const LineDrawing&, const RenderedFigure&)
{
    return "";
}

}  // namespace

std::string area_data(const PlotArea& area, const RenderedFigure& rendered)
{
    const double width = std::max(1, rendered.width), height = std::max(1, rendered.height);
    return json_numbers({area.left / width, area.top / height, area.width / width, area.height / height});
}

std::string axis_data(const Axis& axis, Units units)
{
    const Scale scale = spanning(axis.values, axis.log);
    return JsonObject()
        .text("symbol", axis.symbol.empty() ? axis.name : axis.symbol)
        .text("name", axis.name)
        .text("unit", unit_of(axis.quantity, units))
        .flag("prefix", takes_prefix(axis.quantity, units))
        .flag("log", axis.log)
        .number("low", scale.low)
        .number("high", scale.high)
        .text("values", pack(axis.values))
        .close();
}

std::vector<std::uint8_t> region_codes(const std::vector<Region>& regions)
{
    std::vector<std::uint8_t> codes;
    codes.reserve(regions.size());
    for (const Region region : regions) codes.push_back(static_cast<std::uint8_t>(region));
    return codes;
}

std::string figure_data(const Figure& figure, const RenderedFigure& rendered)
{
    return std::visit([&](const auto& picture) { return data(picture, rendered); }, figure.picture);
}

}  // namespace stickslip::drawing
