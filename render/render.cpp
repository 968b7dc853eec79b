#include "render/render.h"

#include "render/csv/csv.h"
#include "render/drawing/markup.h"
#include "render/pictures/picture.h"

namespace stickslip {

RenderedFigure render(const Figure& figure)
{
    RenderedFigure result;
    const std::string spoken = drawing::plain_text(figure.finding);
    drawing::Drawn drawn;
    {
        const std::scoped_lock turn(drawing::drawing_mutex());
        if (const drawing::Fonts fonts = drawing::find_fonts(); fonts.missing.empty())
            drawn = std::visit([&](const auto& p) { return drawing::draw(p, spoken, fonts); }, figure.picture);
        else
            drawn.missing = fonts.missing;
    }
    result.svg = std::move(drawn.svg);
    result.missing = std::move(drawn.missing);
    result.width = drawn.width;
    result.height = drawn.height;
    const auto area = [](const drawing::Rectangle& box) { return PlotArea{box.left, box.top, box.width, box.height}; };
    result.plot = area(drawn.plot);
    for (const auto& panel : drawn.panels) result.panels.push_back(area(panel));
    result.csv = std::visit([](const auto& picture) { return drawing::csv(picture); }, figure.picture);
    return result;
}

std::vector<RenderedFigure> render(const Report& report)
{
    std::vector<RenderedFigure> figures;
    for (const Section& section : report.sections)
        for (const Figure& figure : section.figures) figures.push_back(render(figure));
    return figures;
}

}  // namespace stickslip
