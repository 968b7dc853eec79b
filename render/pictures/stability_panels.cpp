// Small multiples of a stability map along a third axis and a fourth: what moves the boundaries is seen at one glance.
#include "analysis/results/text.h"
#include "render/drawing/markup.h"
#include "render/pictures/design_mark.h"
#include "render/pictures/picture.h"
#include "render/pictures/stability_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr int picture_width = 900;
constexpr double total_width = 640, gap = 30, title_line = 17, title_gap = 7, row_gap = 10;
constexpr double slimness = 0.76;  // height of a panel per width
constexpr double number_room = 34;

void check(const StabilityPanels& p)
{
    const std::size_t wanted = p.across.values.size() * std::max<std::size_t>(1, p.up.values.size());
    if (p.panels.empty() || p.panels.size() != wanted || p.own >= wanted)
        throw std::invalid_argument("small multiples \"" + p.title + "\": " + std::to_string(p.panels.size()) +
                                    " panels for " + std::to_string(wanted) + " places");
}

/// Along two axes one row to each value of the fourth; along one axis in lines, as words are.
std::size_t column_count(const StabilityPanels& p)
{
    const std::size_t count = p.across.values.size();
    if (!p.up.name.empty() || count <= 3) return count;
    return count == 4 ? 2 : count <= 9 ? 3 : 4;
}

std::vector<std::string> panel_title(const StabilityPanels& p, const StabilityPanel& panel)
{
    const auto held = [&](const Axis& axis, double value) {
        return axis.symbol + " = " + with_unit(value, axis.quantity, p.units);
    };
    std::vector<std::string> lines{held(p.across, panel.across)};
    if (!p.up.name.empty()) lines.push_back(held(p.up, panel.up));
    return lines;
}

std::vector<double> whole_field(const StabilityPanels& p)
{
    std::vector<double> field;
    for (const auto& panel : p.panels) field.insert(field.end(), panel.abscissa.begin(), panel.abscissa.end());
    return field;
}

}  // namespace

Drawn draw(const StabilityPanels& p, const std::string& description, const Fonts& fonts)
{
    check(p);
    const Scale x = spanning(p.x.values, p.x.log), y = spanning(p.y.values, p.y.log);
    const ChartAxis x_axis{x, axis_label(p.x.name, p.x.symbol, p.x.quantity, p.units, x)};
    const ChartAxis y_axis{y, axis_label(p.y.name, p.y.symbol, p.y.quantity, p.units, y)};
    const FieldScale scale = field_scale(whole_field(p));
    const std::size_t columns = column_count(p), rows = (p.panels.size() + columns - 1) / columns;
    const double width = std::floor((total_width - gap * static_cast<double>(columns - 1)) / columns);
    const double height = std::round(slimness * width);
    const double title_height = title_line * (p.up.name.empty() ? 1 : 2) + title_gap;

    Canvas canvas(picture_width, fonts);
    const double top = draw_heading(canvas, axis_margin, picture_width - axis_margin - 20, p.title, p.fixed, "");
    const Rectangle all{axis_margin, top, total_width,
                        static_cast<double>(rows) * (title_height + height + row_gap) - row_gap};
    std::vector<Rectangle> boxes;
    std::vector<StabilityBody> bodies;
    for (std::size_t i = 0; i < p.panels.size(); ++i) {
        const auto& panel = p.panels[i];
        const double left = all.left + static_cast<double>(i % columns) * (width + gap);
        const auto row = i / columns;
        const double above = all.top + static_cast<double>(row) * (title_height + height + row_gap);
        const Frame frame{{left, above + title_height, width, height}, x_axis, y_axis};
        bodies.push_back({p.x, p.y, panel.abscissa, panel.region, panel.curves});
        draw_body(canvas, frame, bodies.back(), scale, p.title);
        if (p.has_design && i == p.own && p.design.inside) draw_cross(canvas, frame.at(p.design.x, p.design.y));
        draw_axes(canvas, frame, {i + columns >= p.panels.size(), i % columns == 0, false});
        double line = above;
        for (const std::string& text : panel_title(p, panel))
            canvas.text({left, line += title_line}, text, {12.5, theme::ink, i == p.own}, Across::left,
                        Along::baseline);
        boxes.push_back(frame.box);
    }
    draw_axis_names(canvas, all, x_axis.label, y_axis.label, number_room);
    draw_body_bar(canvas, {all.left, boxes.front().top, all.width, all.bottom() - boxes.front().top}, scale);
    const double bottom = draw_legend(canvas, body_legend(canvas, bodies, p.has_design && p.design.inside), all.left,
                                      all.bottom() + axis_depth + 16, picture_width - all.left - 16);
    const int tall = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(tall, plain_text(p.title), description), "", picture_width, tall, {}, std::move(boxes)};
}

}  // namespace stickslip::drawing
