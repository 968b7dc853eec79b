// The device behind a canvas: VTK's, whose elements become the SVG. Internal to render/drawing.
#pragma once
#include "render/drawing/canvas.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRenderer.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkXMLDataElement.h>

#include <cmath>
#include <string>
#include <vector>

namespace stickslip::drawing {

// Everything is drawn this many times larger than it is shown, so that whole units are fine enough.
inline constexpr double units_per_pixel = 10;

inline constexpr int tallest = 4000;  // px; the device counts from the bottom of a page that has no height yet

inline double unit(double pixels)
{
    return std::round(pixels * units_per_pixel);
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
        window->SetSize(static_cast<int>(w * units_per_pixel), static_cast<int>(tallest * units_per_pixel));
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
    float y(double pixels) const { return static_cast<float>(tallest * units_per_pixel - unit(pixels)); }

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
        context->GetPen()->SetWidth(static_cast<float>(pen.width * units_per_pixel));
    }

    void use(Colour fill)
    {
        context->GetBrush()->SetColor(fill.red, fill.green, fill.blue,
                                      static_cast<unsigned char>(std::lround(255 * fill.opacity)));
    }

    /// How far the pen moves.
    double width_of(const std::string& text, double size, bool bold) const;
    void letters(Point pen, const std::string& text, double size, const TextStyle& style);

    int classed_from = 0;
};

}  // namespace stickslip::drawing
