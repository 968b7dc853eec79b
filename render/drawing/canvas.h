// The painter of 2-D pictures: lines, areas, hatching, text and rasters, in CSS pixels from the top left, into one SVG.
// No OpenGL is called. VTK is not made for several threads: hold the drawing lock while a canvas lives.
#pragma once
#include "render/drawing/colour.h"
#include "render/drawing/encode.h"
#include "render/drawing/fonts.h"
#include "render/drawing/polyline.h"

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace stickslip::drawing {

/// The one lock around everything that VTK draws, in this floor and in any other that may come to use VTK.
std::mutex& drawing_mutex();

struct Pen {
    Colour colour = theme::ink;
    double width = 1;
    std::vector<double> dash;  ///< on and off lengths; empty: solid
};

struct TextStyle {
    double size = 13;
    Colour colour = theme::ink;
    bool bold = false;
    double angle = 0;   ///< degrees, counter-clockwise
    bool halo = false;  ///< light rim, so that the letters stand on any field
};

/// Which point of the text lies at the given position. `middle` is the middle of the capitals.
enum class Across { left, centre, right };
enum class Along { baseline, middle, top };

class Canvas {
  public:
    /// As wide as the finished picture and as tall as it may become. `fonts` must have been found.
    Canvas(int width, const Fonts& fonts);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    int width() const;

    void line(const Polyline& points, const Pen& pen);
    /// Unconnected stretches, two points each, in one path.
    void stretches(const std::vector<Point>& ends, const Pen& pen);
    void area(const Polyline& corners, Colour fill);
    void rectangle(const Rectangle& box, Colour fill);
    void frame(const Rectangle& box, const Pen& pen);
    void circle(Point centre, double radius, Colour fill);

    /// A raster stretched over `box`; what was drawn before lies beneath.
    void image(const Rectangle& box, const Raster& raster);

    /// Mark-up text. Returns its width.
    double text(Point at, std::string_view markup, const TextStyle& style, Across across, Along along);
    double text_width(std::string_view markup, const TextStyle& style);
    /// Breaks mark-up at spaces into lines no wider than `width`.
    std::vector<std::string> wrap(std::string_view markup, const TextStyle& style, double width);

    /// What is drawn from here on, until `end_class`, carries a class by which the page finds it.
    void begin_class();
    void end_class(const char* name);

    /// The finished picture, cut at `height`; `title` and `description` are spoken by screen readers. Call it once.
    std::string svg(int height, std::string_view title, std::string_view description);

  private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace stickslip::drawing
