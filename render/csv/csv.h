// The numbers behind a picture as a table that any program opens: full precision, SI, one header line.
#pragma once
#include "analysis/results/detailed_chart.h"
#include "analysis/results/line_drawing.h"
#include "analysis/results/stability_panels.h"

#include <string>
#include <string_view>

namespace stickslip::drawing {

std::string csv(const StabilityMap& map);             ///< x, y, abscissa, readings, region; one line a grid point
std::string csv(const StabilityPanels& panels);       ///< the further axes, x, y, abscissa, region
std::string csv(const FieldMap& map);                 ///< x, y, value or class
std::string csv(const CriticalGainSurface& surface);  ///< x, y, z
std::string csv(const LineChart& chart);              ///< line, x, y
std::string csv(const DetailedChart& chart);  ///< the same, what lies below too, and what a curve was drawn over
std::string csv(const LineDrawing& drawing);  ///< nothing: a drawing has no numbers but its words

/// The first line of each, so that other tables of the same numbers carry the same names.
std::string csv_header(const StabilityMap& map);
std::string csv_header(const StabilityPanels& panels);
std::string csv_header(const FieldMap& map);
std::string csv_header(const CriticalGainSurface& surface);
std::string csv_header(const DetailedChart& chart);

/// The shortest digits that read back to the same number; "nan", "inf", "-inf" otherwise.
std::string number(double value);

/// A field, quoted where commas, quotes or line ends ask for it (RFC 4180).
std::string field(std::string_view text);

}  // namespace stickslip::drawing
