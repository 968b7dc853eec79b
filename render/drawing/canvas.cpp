// In one file: one device: everything that is drawn passes through its units and its SVG.
#include "render/drawing/canvas.h"

#include "render/drawing/letters.h"
#include "render/drawing/markup.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRenderer.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkXMLDataElement.h>

#include <cmath>
#include <cstdio>
#include <sstream>

namespace stickslip::drawing {
namespace {

// Everything is drawn this many times larger than it is shown, so that whole units are fine enough.
constexpr double units = 10;

constexpr double capital_height = 0.729;  // of DejaVu Sans, share of the font size

constexpr double small_size = 0.72, raise = 0.36, lower = 0.16;  // sub- and superscripts
constexpr double halo_width = 4;
constexpr int tallest = 4000;  // px; the device counts from the bottom of a page that has no height yet

double unit(double pixels)
{
    return std::round(pixels * units);
}

/// As VTK writes it, so that page.css finds the colours of the theme.
std::string hexadecimal(Colour c)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
    return text;
}

std::string moved_to(Point p)
{
    return "translate(" + std::to_string(std::lround(p.x * units)) + "," + std::to_string(std::lround(p.y * units)) +
           ")";
}

}  // namespace

std::mutex& drawing_mutex()
{
    static std::mutex mutex;
    return mutex;
}

struct Canvas::Device {
    int width;
    Fonts fonts;
    vtkNew<vtkGenericOpenGLRenderWindow> window;  // never rendered: it tells the device the size of the page
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkXMLDataElement> drawing, definitions;
    vtkNew<vtkSVGContextDevice2D> svg;
    vtkNew<vtkContext2D> context;

    Device(int w, const Fonts& f) : width(w), fonts(f)
    {
        window->SetReadyForRendering(false);
        window->SetSize(static_cast<int>(w * units), static_cast<int>(tallest * units));
        window->AddRenderer(renderer);
        drawing->SetName("g");
        drawing->SetAttribute("fill", "none");
        drawing->SetAttribute("stroke-linejoin", "round");
        definitions->SetName("defs");
        svg->SetSVGContext(drawing, definitions);
        svg->Begin(renderer);
        context->Begin(svg);
    }

    float x(double pixels) const { return static_cast<float>(unit(pixels)); }
    float y(double pixels) const { return static_cast<float>(tallest * units - unit(pixels)); }

    std::vector<float> coordinates(const Polyline& points) const
    {
        std::vector<float> list;
        list.reserve(2 * points.size());
        for (const Point& p : points) {
            list.push_back(x(p.x));
            list.push_back(y(p.y));
        }
        return list;
    }

    void use(const Pen& pen)
    {
        context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
        context->GetPen()->SetColor(pen.colour.red, pen.colour.green, pen.colour.blue,
                                    static_cast<unsigned char>(std::lround(255 * pen.colour.opacity)));
        context->GetPen()->SetWidth(static_cast<float>(pen.width * units));
    }

    void use(Colour fill)
    {
        context->GetBrush()->SetColor(fill.red, fill.green, fill.blue,
                                      static_cast<unsigned char>(std::lround(255 * fill.opacity)));
    }

    /// How far the pen moves.
    double width_of(const std::string& text, double size, bool bold) const
    {
        return size * text_advance(bold ? fonts.bold : fonts.regular, text);
    }

    void letters(Point pen, const std::string& text, double size, const TextStyle& style)
    {
        const auto data = outlines(style.bold ? fonts.bold : fonts.regular, text, size * units, style.angle);
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
            path->SetDoubleAttribute("data-size", size * units);
            if (style.bold) path->SetAttribute("data-bold", "1");
            if (style.angle != 0) path->SetDoubleAttribute("data-angle", style.angle);
            drawing->AddNestedElement(path);
            return path;
        };
        if (style.halo) {
            const auto rim = element(field_halo);
            rim->SetAttribute("stroke", hexadecimal(field_halo).c_str());
            rim->SetDoubleAttribute("stroke-width", halo_width * units);
        }
        element(style.colour);
    }

    int classed_from = 0;
};

Canvas::Canvas(int width, const Fonts& fonts) : device_(std::make_unique<Device>(width, fonts)) {}

Canvas::~Canvas() = default;

int Canvas::width() const
{
    return device_->width;
}

void Canvas::line(const Polyline& points, const Pen& pen)
{
    if (points.size() < 2) return;
    if (!pen.dash.empty()) return stretches(dashes(points, pen.dash), pen);
    device_->use(pen);
    auto list = device_->coordinates(points);
    device_->context->DrawPoly(list.data(), static_cast<int>(points.size()));
}

void Canvas::stretches(const std::vector<Point>& ends, const Pen& pen)
{
    if (ends.empty()) return;
    device_->use(pen);
    auto list = device_->coordinates(ends);
    device_->context->DrawLines(list.data(), static_cast<int>(ends.size()));
}

void Canvas::area(const Polyline& corners, Colour fill)
{
    device_->use(fill);
    auto list = device_->coordinates(corners);
    // Past the context, which would add an outline element to every area, even with an invisible pen.
    device_->svg->DrawPolygon(list.data(), static_cast<int>(corners.size()));
}

void Canvas::rectangle(const Rectangle& box, Colour fill)
{
    area({{box.left, box.top}, {box.right(), box.top}, {box.right(), box.bottom()}, {box.left, box.bottom()}}, fill);
}

void Canvas::frame(const Rectangle& box, const Pen& pen)
{
    line({{box.left, box.top},
          {box.right(), box.top},
          {box.right(), box.bottom()},
          {box.left, box.bottom()},
          {box.left, box.top}},
         pen);
}

void Canvas::circle(Point centre, double radius, Colour fill)
{
    Polyline corners;
    constexpr int sides = 24;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * i / sides;
        corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    area(corners, fill);
}

void Canvas::image(const Rectangle& box, const Raster& raster)
{
    vtkNew<vtkXMLDataElement> element;
    element->SetName("image");
    element->SetDoubleAttribute("x", unit(box.left));
    element->SetDoubleAttribute("y", unit(box.top));
    element->SetDoubleAttribute("width", unit(box.width));
    element->SetDoubleAttribute("height", unit(box.height));
    element->SetAttribute("preserveAspectRatio", "none");
    element->SetAttribute("href", ("data:image/png;base64," + base64(png(raster))).c_str());
    device_->drawing->AddNestedElement(element);
}

void Canvas::begin_class()
{
    device_->classed_from = device_->drawing->GetNumberOfNestedElements();
}

void Canvas::end_class(const char* name)
{
    for (int i = device_->classed_from; i < device_->drawing->GetNumberOfNestedElements(); ++i)
        device_->drawing->GetNestedElement(i)->SetAttribute("class", name);
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

std::string Canvas::svg(int height, std::string_view title, std::string_view description)
{
    device_->context->End();
    device_->svg->GenerateDefinitions();
    vtkNew<vtkXMLDataElement> root, name, paper;
    root->SetName("svg");
    root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    std::ostringstream box;
    box << "0 0 " << device_->width * units << ' ' << height * units;
    root->SetAttribute("viewBox", box.str().c_str());
    root->SetIntAttribute("width", device_->width);
    root->SetIntAttribute("height", height);
    root->SetAttribute("role", "img");
    root->SetAttribute("aria-label", std::string(description).c_str());
    name->SetName("title");
    name->SetCharacterData(std::string(title).c_str(), static_cast<int>(title.size()));
    root->AddNestedElement(name);
    paper->SetName("rect");
    paper->SetAttribute("width", "100%");
    paper->SetAttribute("height", "100%");
    paper->SetAttribute("fill", "#ffffff");
    root->AddNestedElement(paper);
    root->AddNestedElement(device_->drawing);
    std::ostringstream text;
    root->PrintXML(text, vtkIndent());
    return text.str();
}

}  // namespace stickslip::drawing
