// What every picture hands back, and the pictures.
#pragma once
#include "analysis/results/detailed_chart.h"
#include "analysis/results/line_drawing.h"
#include "analysis/results/stability_panels.h"
#include "render/drawing/canvas.h"

#include <string>
#include <vector>

namespace stickslip::drawing {

struct Drawn {
    std::string svg;      ///< empty when the picture could not be made
    std::string missing;  ///< and then why
    int width = 0, height = 0;
    Rectangle plot;                 ///< where the data area lies
    std::vector<Rectangle> panels;  ///< or several of them
};

/// Each draws under the drawing lock, which the caller holds, and throws std::invalid_argument on arrays that do not
/// match. `description` is what a screen reader says.
Drawn draw(const StabilityMap& map, const std::string& description, const Fonts& fonts);
Drawn draw(const StabilityPanels& panels, const std::string& description, const Fonts& fonts);
Drawn draw(const CriticalGainSurface& surface, const std::string& description, const Fonts& fonts);
Drawn draw(const FieldMap& map, const std::string& description, const Fonts& fonts);
Drawn draw(const DetailedChart& chart, const std::string& description, const Fonts& fonts);
Drawn draw(const LineChart& chart, const std::string& description, const Fonts& fonts);
Drawn draw(const LineDrawing& drawing, const std::string& description, const Fonts& fonts);

}  // namespace stickslip::drawing
