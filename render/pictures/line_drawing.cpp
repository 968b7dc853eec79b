// Lines, boxes, rings and words where the drawing says they are.
#include "analysis/results/line_drawing.h"

#include "render/drawing/markup.h"
#include "render/pictures/picture.h"

#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr double margin = 24, heading = 44, note_line = 22;
constexpr int least_width = 900, widest = 4000;  // as wide as the charts, so that letters are of one size
const TextStyle title_style{15, theme::ink, true}, label_style{13, theme::ink}, note_style{12.5, theme::muted};

Across side(LineDrawing::Anchor anchor)
{
    return anchor == LineDrawing::Anchor::left    ? Across::left
           : anchor == LineDrawing::Anchor::right ? Across::right
                                                  : Across::centre;
}

void check(const LineDrawing& d)
{
    const bool fits = d.width > 0 && d.width <= widest && d.height > 0 && d.height <= widest;
    if (!fits) throw std::invalid_argument("drawing \"" + d.title + "\": its size must lie within 1 and 4000 pixels");
}

}  // namespace

Drawn draw(const LineDrawing& d, const std::string& description, const Fonts& fonts)
{
    check(d);
    const int width = std::max(least_width, static_cast<int>(std::ceil(d.width)));
    Canvas canvas(width, fonts);
    canvas.text({margin, heading / 2}, d.title, title_style, Across::left, Along::middle);
    const Pen pen{theme::ink, 1.5, {}};
    const double left = (width - d.width) / 2;
    for (const auto& line : d.lines) {
        Polyline points;
        for (const auto& [x, y] : line) points.push_back({left + x, heading + y});
        canvas.line(points, pen);
    }
    for (const auto& box : d.boxes) {
        const Rectangle at{left + box.left, heading + box.top, box.width, box.height};
        canvas.rectangle(at, theme::paper);
        canvas.frame(at, pen);
    }
    for (const auto& bar : d.bars)
        canvas.rectangle({left + bar.left, heading + bar.top, bar.width, bar.height}, theme::ink);
    for (const auto& ring : d.rings) {
        const Point centre{left + ring.x, heading + ring.y};
        canvas.circle(centre, ring.radius + pen.width / 2, theme::ink);
        canvas.circle(centre, ring.radius - pen.width / 2, theme::paper);
    }
    for (const auto& label : d.labels)
        canvas.text({left + label.x, heading + label.y}, label.text, label_style, side(label.anchor), Along::baseline);
    double bottom = heading + d.height;
    for (const auto& note : d.notes)
        for (const auto& line : canvas.wrap(note, note_style, width - 2 * margin)) {
            bottom += note_line;
            canvas.text({margin, bottom - 6}, line, note_style, Across::left, Along::baseline);
        }
    const int height = static_cast<int>(std::ceil(bottom)) + 6;
    return {canvas.svg(height, plain_text(d.title), description), "", width, height, {}};
}

}  // namespace stickslip::drawing
