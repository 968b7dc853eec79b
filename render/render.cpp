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
    result.plot_left = drawn.plot.left;
    result.plot_top = drawn.plot.top;
    result.plot_width = drawn.plot.width;
    result.plot_height = drawn.plot.height;
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
