// Text on a canvas: its letters as outlines, runs of mark-up, lines.
#include "render/drawing/canvas_device.h"

#include "render/drawing/letters.h"
#include "render/drawing/markup.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace stickslip::drawing {
namespace {

constexpr double capital_height = 0.729;  // of DejaVu Sans, share of the font size

constexpr double small_size = 0.72, raise = 0.36, lower = 0.16;  // sub- and superscripts
constexpr double halo_width = 4;

/// As VTK writes it, so that page.css finds the colours of the theme.
std::string hexadecimal(Colour c)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
    return text;
}

std::string moved_to(Point p)
{
    return "translate(" + std::to_string(std::lround(p.x * units_per_pixel)) + "," +
           std::to_string(std::lround(p.y * units_per_pixel)) + ")";
}

}  // namespace

double Canvas::Device::width_of(const std::string& text, double size, bool bold) const
{
    return size * text_advance(bold ? fonts.bold : fonts.regular, text);
}

void Canvas::Device::letters(Point pen, const std::string& text, double size, const TextStyle& style)
{
    const auto data = outlines(style.bold ? fonts.bold : fonts.regular, text, size * units_per_pixel, style.angle);
    if (data.empty()) return;
    const auto element = [&](Colour fill) {
        vtkNew<vtkXMLDataElement> path;
        path->SetName("path");
        path->SetAttribute("fill", hexadecimal(fill).c_str());
        if (fill.opacity < 1) path->SetDoubleAttribute("fill-opacity", fill.opacity);
        path->SetAttribute("transform", moved_to(pen).c_str());
        path->SetAttribute("d", data.c_str());
        // what the outlines say, for who wants to search or edit a saved picture
        path->SetAttribute("data-text", text.c_str());
        path->SetDoubleAttribute("data-size", size * units_per_pixel);
        if (style.bold) path->SetAttribute("data-bold", "1");
        if (style.angle != 0) path->SetDoubleAttribute("data-angle", style.angle);
        drawing->AddNestedElement(path);
        return path;
    };
    if (style.halo) {
        const auto rim = element(field_halo);
        rim->SetAttribute("stroke", hexadecimal(field_halo).c_str());
        rim->SetDoubleAttribute("stroke-width", halo_width * units_per_pixel);
    }
    element(style.colour);
}

double Canvas::text_width(std::string_view markup, const TextStyle& style)
{
    double width = 0;
    for (const Run& run : parse_markup(markup)) {
        const double size = run.level == Run::Level::base ? style.size : small_size * style.size;
        width += device_->width_of(run.text, size, style.bold);
    }
    return width;
}

double Canvas::text(Point at, std::string_view markup, const TextStyle& style, Across across, Along along)
{
    const double width = text_width(markup, style);
    const double turn = style.angle * M_PI / 180;
    double along_line = across == Across::left ? 0 : across == Across::centre ? -width / 2 : -width;
    const double up = along == Along::baseline ? 0 : -capital_height * style.size * (along == Along::middle ? 0.5 : 1);
    for (const Run& run : parse_markup(markup)) {
        const bool base = run.level == Run::Level::base;
        const double size = base ? style.size : small_size * style.size;
        const double lift = base ? 0 : style.size * (run.level == Run::Level::superscript ? raise : -lower);
        const double step = device_->width_of(run.text, size, style.bold);
        const double height = up + lift;
        const Point pen{at.x + along_line * std::cos(turn) - height * std::sin(turn),
                        at.y - along_line * std::sin(turn) - height * std::cos(turn)};
        device_->letters(pen, run.text, size, style);
        along_line += step;
    }
    return width;
}

std::vector<std::string> Canvas::wrap(std::string_view markup, const TextStyle& style, double width)
{
    std::vector<std::string> lines;
    std::istringstream words{std::string(markup)};
    for (std::string word; words >> word;) {
        const std::string longer = lines.empty() ? word : lines.back() + " " + word;
        if (lines.empty() || text_width(longer, style) > width)
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    return lines;
}

}  // namespace stickslip::drawing
