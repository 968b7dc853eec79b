#include "render/axes/frame.h"

#include <algorithm>

namespace stickslip::drawing {
namespace {

constexpr double major_length = 6, minor_length = 3.5;
constexpr double pixels_per_x_label = 90, pixels_per_y_label = 60;
constexpr TextStyle tick_style{13}, name_style{14.5};

/// A single label says nothing about a scale.
int room(double labels)
{
    return std::max(2, static_cast<int>(labels));
}

Ticks x_ticks(const Frame& frame)
{
    return ticks(frame.x.scale, room(frame.box.width / pixels_per_x_label), frame.x.label.divisor);
}

Ticks y_ticks(const Frame& frame)
{
    return ticks(frame.y.scale, room(frame.box.height / pixels_per_y_label), frame.y.label.divisor);
}

double across(const Frame& frame, double value)
{
    return frame.box.left + frame.box.width * frame.x.scale.at(value);
}

double down(const Frame& frame, double value)
{
    return frame.box.bottom() - frame.box.height * frame.y.scale.at(value);
}

}  // namespace

Point Frame::at(double x_value, double y_value) const
{
    return {across(*this, x_value), down(*this, y_value)};
}

void draw_grid(Canvas& canvas, const Frame& frame)
{
    std::vector<Point> ends;
    for (const Tick& tick : x_ticks(frame).major) {
        ends.push_back({across(frame, tick.value), frame.box.top});
        ends.push_back({across(frame, tick.value), frame.box.bottom()});
    }
    for (const Tick& tick : y_ticks(frame).major) {
        ends.push_back({frame.box.left, down(frame, tick.value)});
        ends.push_back({frame.box.right(), down(frame, tick.value)});
    }
    canvas.stretches(ends, {theme::rule, 0.8});
}

void draw_axes(Canvas& canvas, const Frame& frame, const AxisLetters& letters)
{
    const Ticks x = x_ticks(frame), y = y_ticks(frame);
    std::vector<Point> ends;
    const auto below = [&](double value, double length) {
        ends.push_back({across(frame, value), frame.box.bottom()});
        ends.push_back({across(frame, value), frame.box.bottom() + length});
    };
    const auto beside = [&](double value, double length) {
        ends.push_back({frame.box.left, down(frame, value)});
        ends.push_back({frame.box.left - length, down(frame, value)});
    };
    for (const Tick& tick : x.major) below(tick.value, major_length);
    for (const double value : x.minor) below(value, minor_length);
    for (const Tick& tick : y.major) beside(tick.value, major_length);
    for (const double value : y.minor) beside(value, minor_length);
    canvas.stretches(ends, {theme::ink, 1});
    canvas.frame(frame.box, {theme::ink, 1.2});

    double widest = 0;
    if (letters.x_numbers)
        for (const Tick& tick : x.major)
            canvas.text({across(frame, tick.value), frame.box.bottom() + 11}, tick.label, tick_style, Across::centre,
                        Along::top);
    if (letters.y_numbers)
        for (const Tick& tick : y.major)
            widest = std::max(widest, canvas.text({frame.box.left - 10, down(frame, tick.value)}, tick.label,
                                                  tick_style, Across::right, Along::middle));
    if (letters.names) draw_axis_names(canvas, frame.box, frame.x.label, frame.y.label, widest);
}

void draw_axis_names(Canvas& canvas, const Rectangle& box, const AxisLabel& x, const AxisLabel& y, double numbers)
{
    canvas.text({box.left + box.width / 2, box.bottom() + 46}, x.text, name_style, Across::centre, Along::baseline);
    TextStyle upright = name_style;
    upright.angle = 90;
    canvas.text({box.left - 24 - numbers, box.top + box.height / 2}, y.text, upright, Across::centre, Along::baseline);
}

void draw_colour_bar(Canvas& canvas, const ColourBar& bar, const Raster& colours)
{
    canvas.image(bar.box, colours);
    std::vector<Point> ends;
    double widest = 0;
    for (const auto& mark : bar.marks) {
        const double y = bar.box.bottom() - bar.box.height * mark.position;
        ends.push_back({bar.box.right(), y});
        ends.push_back({bar.box.right() + (mark.label.empty() ? minor_length : major_length), y});
        widest = std::max(widest,
                          canvas.text({bar.box.right() + 10, y}, mark.label, tick_style, Across::left, Along::middle));
    }
    canvas.stretches(ends, {theme::ink, 1});
    canvas.frame(bar.box, {theme::ink, 1});
    TextStyle upright = name_style;
    upright.angle = 90;
    canvas.text({bar.box.right() + 10 + widest + 22, bar.box.top + bar.box.height / 2}, bar.label, upright,
                Across::centre, Along::baseline);
}

double draw_heading(Canvas& canvas, double left, double width, const std::string& title, const std::string& fixed,
                    const std::string& statement)
{
    constexpr TextStyle title_style{17, theme::ink, true}, fixed_style{12.5, theme::muted}, statement_style{12.5};
    double y = 10;
    const auto write = [&](const std::string& text, const TextStyle& style, double line_height) {
        for (const std::string& line : canvas.wrap(text, style, width)) {
            y += line_height;
            canvas.text({left, y}, line, style, Across::left, Along::baseline);
        }
    };
    write(title, title_style, 22);
    canvas.begin_class();
    write(fixed, fixed_style, 19);
    write(statement, statement_style, 19);
    canvas.end_class("held");  // the page hides it while its slider shows other values
    return y + 14;
}

}  // namespace stickslip::drawing
