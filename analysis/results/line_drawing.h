// A drawing of lines, boxes and words rather than of numbers over axes: a lumped model with its parameters.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// Coordinates in CSS pixels from the top left, y downwards; texts in chart mark-up ("k_{p}").
struct LineDrawing {
    enum class Anchor { left, middle, right };
    struct Box {
        double left, top, width, height;
    };
    struct Ring {
        double x, y, radius;
    };
    struct Label {
        double x, y;  ///< of the baseline
        std::string text;
        Anchor anchor = Anchor::middle;
    };

    std::string title;
    std::vector<std::string> notes;  ///< lines below the drawing
    double width = 0, height = 0;    ///< of the drawing, without title and notes
    std::vector<std::vector<std::pair<double, double>>> lines;
    std::vector<Box> boxes;
    std::vector<Box> bars;    ///< filled
    std::vector<Ring> rings;  ///< above the lines
    std::vector<Label> labels;
};

}  // namespace stickslip
