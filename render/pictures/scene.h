// The 3-D part of the surface picture: the surface itself as pixels, and where the corners and ticks of its box fall on
// the page. Everything with letters is drawn flat, on top.
#pragma once
#include "render/drawing/polyline.h"
#include "render/pictures/off_screen.h"

#include <array>
#include <memory>
#include <vector>

namespace stickslip::drawing {

/// A height field in the unit cube: columns and rows in [0, 1], heights row by row, NaN for a hole.
struct HeightField {
    std::vector<double> columns, rows, heights;
    std::vector<double> levels;                       ///< heights at which dark contour lines run over the surface
    std::vector<double> columns_marked, rows_marked;  ///< places of light lines along the surface, to show its shape
};

class Scene {
  public:
    /// The box fills a window of the given width from (left, top); the height follows from the view.
    Scene(const HeightField& field, double left, double top, double width);
    ~Scene();

    const Rectangle& window() const { return window_; }

    /// Where a point of the unit cube falls in the window.
    Point project(double x, double y, double z) const;

    /// The surface seen through the window, `fineness` pixels to a CSS pixel.
    Snapshot photograph(int fineness) const;

  private:
    struct Stage;
    Rectangle window_;
    std::unique_ptr<Stage> stage_;
};

}  // namespace stickslip::drawing
