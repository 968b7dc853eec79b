// The floor's whole interface: results in, bytes out. No file is read but the typeface, none is written; VTK stays
// inside. Safe to call from several threads: drawing takes turns on one lock.
#pragma once
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// A data area within a picture, px from its top left corner.
struct PlotArea {
    double left = 0, top = 0, width = 0, height = 0;
};

/// One chart, made.
struct RenderedFigure {
    std::string svg;      ///< the picture, stand-alone; empty when it could not be made
    std::string csv;      ///< the numbers behind it, SI, full precision
    std::string missing;  ///< why there is no picture, in words for the reader; empty when there is one

    int width = 0, height = 0;     ///< of the picture in CSS pixels
    PlotArea plot;                 ///< where a pointer reads values; empty where the picture has several areas
    std::vector<PlotArea> panels;  ///< and then these
};

/// Draws one figure. A machine without the typeface or (3-D only) without an off-screen OpenGL gives `missing`, not an
/// exception. Throws std::invalid_argument when the arrays of the picture do not fit together.
RenderedFigure render(const Figure& figure);

/// The picture as PNG, half again as fine as CSS pixels; empty where there is none. Equal pictures give equal bytes.
/// Throws std::runtime_error if the picture cannot be read.
std::string png(const RenderedFigure& figure);

/// Stands for all that a figure's picture and numbers are made of: its data and words, this program's drawing, the
/// typeface. Figures with equal keys give equal bytes, so that what was drawn once can be kept.
std::string figure_key(const Figure& figure);

/// Every figure of a report, in the order of the page.
std::vector<RenderedFigure> render(const Report& report);

/// The report as one HTML file that needs no network: pictures, data, style and script are all inside, and a content
/// security policy forbids the rest. Equal reports give equal bytes. `figures` are those of render(report); throws
/// std::invalid_argument when their number differs, or when an id is empty, used twice or not made of [a-z0-9-].
std::string page(const Report& report, const std::vector<RenderedFigure>& figures);

}  // namespace stickslip
