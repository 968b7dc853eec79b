#include "render/csv/csv.h"

#include "render/drawing/markup.h"
#include "render/pictures/regions.h"

#include <array>
#include <charconv>
#include <cmath>

namespace stickslip::drawing {
namespace {

std::string column(const std::string& name, Quantity quantity, Units units)
{
    const auto unit = unit_of(quantity, units);
    return field(plain_text(name) + (unit == "1" ? "" : " [" + std::string(unit) + "]"));
}

}  // namespace

std::string number(double value)
{
    if (std::isnan(value)) return "nan";
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string field(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string csv_header(const StabilityMap& map)
{
    std::string text = column(map.x.path, map.x.quantity, map.units) + "," +
                       column(map.y.path, map.y.quantity, map.units) + ",spectral abscissa [1/s],";
    for (const auto& reading : map.readings) text += column(reading.name, reading.quantity, map.units) + ",";
    return text + "region";
}

std::string csv(const StabilityMap& map)
{
    std::string text = csv_header(map) + "\n";
    std::size_t i = 0;
    for (const double y : map.y.values)
        for (const double x : map.x.values) {
            text += number(x) + "," + number(y) + "," + number(map.abscissa[i]) + ",";
            for (const auto& reading : map.readings) text += number(reading.values[i]) + ",";
            text += region_name(map.region[i++]);
            text += '\n';
        }
    return text;
}

std::string csv_header(const StabilityPanels& p)
{
    std::string text;
    for (const Axis* axis : {&p.up, &p.across, &p.x, &p.y})
        if (!axis->name.empty()) text += column(axis->path, axis->quantity, p.units) + ",";
    return text + "spectral abscissa [1/s],region";
}

std::string csv(const StabilityPanels& p)
{
    std::string text = csv_header(p) + "\n";
    for (const auto& panel : p.panels) {
        const std::string place = (p.up.name.empty() ? "" : number(panel.up) + ",") + number(panel.across) + ",";
        std::size_t i = 0;
        for (const double y : p.y.values)
            for (const double x : p.x.values) {
                text += place + number(x) + "," + number(y) + "," + number(panel.abscissa[i]) + ",";
                text += region_name(panel.region[i++]);
                text += '\n';
            }
    }
    return text;
}

std::string csv_header(const FieldMap& map)
{
    return column(map.x.path, map.x.quantity, map.units) + "," + column(map.y.path, map.y.quantity, map.units) + "," +
           (map.classes.empty() ? column(map.name, map.quantity, map.units) : field(map.name));
}

std::string csv(const FieldMap& map)
{
    std::string text = csv_header(map) + "\n";
    std::size_t i = 0;
    for (const double y : map.y.values)
        for (const double x : map.x.values) {
            const double value = map.values[i++];
            text += number(x) + "," + number(y) + ",";
            text +=
                map.classes.empty() ? number(value) : field(plain_text(map.classes[static_cast<std::size_t>(value)]));
            text += '\n';
        }
    return text;
}

std::string csv_header(const CriticalGainSurface& surface)
{
    return column(surface.x.path, surface.x.quantity, surface.units) + "," +
           column(surface.y.path, surface.y.quantity, surface.units) + "," +
           column(surface.z_name, surface.z_quantity, surface.units);
}

std::string csv(const CriticalGainSurface& surface)
{
    std::string text = csv_header(surface) + "\n";
    std::size_t i = 0;
    for (const double y : surface.y.values)
        for (const double x : surface.x.values)
            text += number(x) + "," + number(y) + "," + number(surface.z[i++]) + "\n";
    return text;
}

std::string csv(const LineDrawing&)
{
    return "";
}

std::string csv_header(const DetailedChart& chart)
{
    const std::string own = chart.y_label.text(), below = chart.below_label.text();
    const std::string label = own + (chart.below.empty() || below == own ? "" : " | " + below);
    return "line," + field(plain_text(chart.x_label.text())) + "," + field(plain_text(label)) +
           (chart.along_label.name.empty() ? "" : "," + field(plain_text(chart.along_label.text())));
}

std::string csv(const DetailedChart& chart)
{
    const bool along = !chart.along_label.name.empty();
    std::string text = csv_header(chart) + "\n";
    for (const auto* lines : {&chart.lines, &chart.below})
        for (const auto& line : *lines) {
            const std::string name = field(plain_text(line.name)) + ",";
            for (std::size_t i = 0; i < line.x.size(); ++i)
                text += name + number(line.x[i]) + "," + number(line.y[i]) +
                        (along ? "," + (line.along.empty() ? std::string() : number(line.along[i])) : "") + "\n";
        }
    return text;
}

std::string csv(const LineChart& chart)
{
    return csv(detailed(chart));
}

}  // namespace stickslip::drawing
