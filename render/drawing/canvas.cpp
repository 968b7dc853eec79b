#include "render/drawing/canvas.h"

#include "render/drawing/canvas_device.h"

#include <cmath>
#include <sstream>

namespace stickslip::drawing {

std::mutex& drawing_mutex()
{
    static std::mutex mutex;
    return mutex;
}

Canvas::Canvas(int width, const Fonts& fonts) : device_(std::make_unique<Device>(width, fonts)) {}

Canvas::~Canvas() = default;

int Canvas::width() const
{
    return device_->width;
}

void Canvas::line(const Polyline& points, const Pen& pen)
{
    if (points.size() < 2) return;
    if (shows_dashes(points, pen.dash)) return stretches(dashes(points, pen.dash), pen);
    device_->use(pen);
    for (const Polyline& piece : strokes(points)) {
        auto list = device_->coordinates(piece);
        device_->context->DrawPoly(list.data(), static_cast<int>(piece.size()));
    }
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

std::string Canvas::svg(int height, std::string_view title, std::string_view description)
{
    device_->context->End();
    device_->svg->GenerateDefinitions();
    vtkNew<vtkXMLDataElement> root, name, paper;
    root->SetName("svg");
    root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    std::ostringstream box;
    box << "0 0 " << device_->width * units_per_pixel << ' ' << height * units_per_pixel;
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
