#include "render/page/figure_data.h"

#include "analysis/results/text.h"
#include "render/axes/scale.h"
#include "render/csv/csv.h"
#include "render/drawing/encode.h"
#include "render/drawing/markup.h"
#include "render/page/html.h"
#include "render/pictures/regions.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace stickslip::drawing {
namespace {

static_assert(std::endian::native == std::endian::little, "the page's data blocks are little-endian");

template <class Number>
std::string block(const std::vector<Number>& numbers)
{
    return base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

std::string floats(const std::vector<double>& field)
{
    return block(std::vector<float>(field.begin(), field.end()));
}

/// One JSON object, member by member.
class Object {
  public:
    Object& text(std::string_view name, std::string_view value) { return raw(name, json_string(value)); }
    Object& flag(std::string_view name, bool value) { return raw(name, value ? "true" : "false"); }
    Object& numbers(std::string_view name, const std::vector<double>& values)
    {
        std::string list;
        for (const double v : values) list.append(list.empty() ? "" : ",").append(number(v));
        return raw(name, "[" + list + "]");
    }
    Object& raw(std::string_view name, std::string_view json)
    {
        text_.append(text_.empty() ? "{" : ",").append(json_string(name)).append(":").append(json);
        return *this;
    }
    std::string close() const { return text_ + "}"; }

  private:
    std::string text_;
};

std::string array(const std::vector<std::string>& items)
{
    std::string list;
    for (const std::string& item : items) list.append(list.empty() ? "" : ",").append(item);
    return "[" + list + "]";
}

std::string axis_data(const Axis& axis, Motion motion)
{
    const Scale scale = spanning(axis.values, axis.log);
    const std::string unit(unit_of(axis.quantity, motion));
    return Object()
        .text("symbol", axis.symbol.empty() ? axis.name : axis.symbol)
        .text("unit", unit)
        .flag("prefix", scaled_unit(1e3, axis.quantity, motion).text != unit)
        .flag("log", axis.log)
        .raw("low", number(scale.low))
        .raw("high", number(scale.high))
        .text("values", block(axis.values))
        .close();
}

/// The header line of the figure's CSV file, so that both tables carry the same names.
std::string header(const RenderedFigure& rendered)
{
    return rendered.csv.substr(0, rendered.csv.find('\n'));
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

std::string data(const StabilityMap& map, const RenderedFigure& rendered)
{
    const double width = std::max(1, rendered.width), height = std::max(1, rendered.height);
    std::vector<std::string> regions;
    for (int i = 0; i <= static_cast<int>(Region::undecided); ++i) {
        const auto region = static_cast<Region>(i);
        regions.push_back(Object().text("name", region_name(region)).text("text", region_text(region)).close());
    }
    const bool design = map.has_design && map.design.inside;
    const std::size_t column = design ? nearest(map.x, map.design.x) : map.x.values.size() / 2;
    const std::size_t row = design ? nearest(map.y, map.design.y) : map.y.values.size() / 2;
    return Object()
        .text("kind", "map")
        .text("header", header(rendered))
        .numbers("area", {rendered.plot_left / width, rendered.plot_top / height, rendered.plot_width / width,
                          rendered.plot_height / height})
        .numbers("start", {static_cast<double>(column), static_cast<double>(row)})
        .raw("x", axis_data(map.x, map.motion))
        .raw("y", axis_data(map.y, map.motion))
        .raw("regions", array(regions))
        .text("field", floats(map.abscissa))
        .text("region", block(map.region))
        .close();
}

std::string data(const CriticalGainSurface& surface, const RenderedFigure& rendered)
{
    return Object()
        .text("kind", "surface")
        .text("header", header(rendered))
        .raw("x", axis_data(surface.x, surface.motion))
        .raw("y", axis_data(surface.y, surface.motion))
        .text("field", floats(surface.z))
        .close();
}

std::string data(const LineChart& chart, const RenderedFigure& rendered)
{
    std::vector<std::string> lines;
    for (const auto& line : chart.lines)
        lines.push_back(
            Object().text("name", plain_text(line.name)).text("x", block(line.x)).text("y", block(line.y)).close());
    return Object().text("kind", "lines").text("header", header(rendered)).raw("lines", array(lines)).close();
}

}  // namespace

std::string figure_data(const Figure& figure, const RenderedFigure& rendered)
{
    return std::visit([&](const auto& picture) { return data(picture, rendered); }, figure.picture);
}

}  // namespace stickslip::drawing
