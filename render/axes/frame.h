// The axes of a chart on the canvas: box, ticks, labels, and where a data point lies.
#pragma once
#include "render/axes/scale.h"
#include "render/drawing/canvas.h"

namespace stickslip::drawing {

struct ChartAxis {
    Scale scale;
    AxisLabel label;
};

struct Frame {
    Rectangle box;
    ChartAxis x, y;

    Point at(double x_value, double y_value) const;
};

/// Distance from the box to the lower edge of the x axis's name, and how wide the left margin should be.
constexpr double axis_depth = 52, axis_margin = 96;

void draw_grid(Canvas& canvas, const Frame& frame);
/// Which letters an axis gets: panels side by side share them.
struct AxisLetters {
    bool x_numbers = true, y_numbers = true, names = true;
};
void draw_axes(Canvas& canvas, const Frame& frame, const AxisLetters& letters = {});

/// The names alone, around a box that may hold several frames; `numbers` is the width that the y axis's numbers take.
void draw_axis_names(Canvas& canvas, const Rectangle& box, const AxisLabel& x, const AxisLabel& y, double numbers);

/// A vertical colour bar with its own ticks; `positions` in [0, 1] from below.
struct ColourBar {
    Rectangle box;
    struct Mark {
        double position;
        std::string label;  ///< mark-up; empty: a minor tick
    };
    std::vector<Mark> marks;
    std::string label;  ///< mark-up
};
void draw_colour_bar(Canvas& canvas, const ColourBar& bar, const Raster& colours);

/// Title, held parameters and a statement, from the top of the picture. Returns where the chart may begin.
double draw_heading(Canvas& canvas, double left, double width, const std::string& title, const std::string& fixed,
                    const std::string& statement);

}  // namespace stickslip::drawing
