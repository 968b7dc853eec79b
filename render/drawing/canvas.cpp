#include "render/drawing/canvas.h"

#include "render/drawing/markup.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRenderer.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkTextProperty.h>
#include <vtkXMLDataElement.h>

#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace stickslip::drawing {
namespace {

// Everything is drawn this many times larger than it is shown: VTK fits letters to whole units, and at ten units a
// pixel neither their shapes nor their distances show it.
constexpr double units = 10;

// DejaVu Sans, shares of the font size. VTK anchors the box that includes the descender.
constexpr double descender = 0.236, capital_height = 0.729;

constexpr double small_size = 0.72, raise = 0.36, lower = 0.16;  // sub- and superscripts
constexpr double halo_width = 4;
constexpr int tallest = 4000;  // px; the device counts from the bottom of a page that has no height yet

double unit(double pixels)
{
    return std::round(pixels * units);
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
    vtkNew<vtkTextProperty> letters;

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
        svg->SetTextAsPath(true);
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

    void use(double size, bool bold, Colour colour, double angle)
    {
        letters->SetFontFamily(VTK_FONT_FILE);
        letters->SetFontFile((bold ? fonts.bold : fonts.regular).c_str());
        letters->SetFontSize(static_cast<int>(std::lround(size * units)));
        letters->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
        letters->SetOpacity(colour.opacity);
        letters->SetOrientation(angle);
        letters->SetJustificationToLeft();
        letters->SetVerticalJustificationToBottom();
        context->ApplyTextProp(letters);
    }

    double measured(const std::string& text, double size, bool bold)
    {
        // the charts of a page share most of their words, and layouts ask for them many times
        thread_local std::map<std::tuple<std::string, std::string, double>, double> widths;
        const auto [known, fresh] = widths.try_emplace({bold ? fonts.bold : fonts.regular, text, size}, 0.0);
        if (fresh) {
            use(size, bold, {}, 0);
            float box[4];
            context->ComputeStringBounds(text.c_str(), box);
            known->second = box[2] / units;
        }
        return known->second;
    }

    /// How far the pen moves. Measured between two letters, because the box of a text leaves out spaces at its ends.
    double advance(const std::string& text, double size, bool bold)
    {
        return measured("x" + text + "x", size, bold) - measured("xx", size, bold);
    }

    int classed_from = 0;

    void last_element_as_halo(double width_in_units)
    {
        auto* element = drawing->GetNestedElement(drawing->GetNumberOfNestedElements() - 1);
        element->SetAttribute("stroke", element->GetAttribute("fill"));
        element->SetDoubleAttribute("stroke-width", width_in_units);
    }
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
        width += device_->advance(run.text, size, style.bold);
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
        const double step = device_->advance(run.text, size, style.bold);
        const double height = up + lift - descender * size;
        const double x = at.x + along_line * std::cos(turn) - height * std::sin(turn);
        const double y = at.y - along_line * std::sin(turn) - height * std::cos(turn);
        if (style.halo) {
            device_->use(size, style.bold, field_halo, style.angle);
            device_->context->DrawString(device_->x(x), device_->y(y), run.text.c_str());
            device_->last_element_as_halo(halo_width * units);
        }
        device_->use(size, style.bold, style.colour, style.angle);
        device_->context->DrawString(device_->x(x), device_->y(y), run.text.c_str());
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
