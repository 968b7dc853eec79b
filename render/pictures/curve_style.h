// How a boundary is drawn and named: the same on every chart of a page.
#pragma once
#include "analysis/results/stability_map.h"
#include "render/drawing/canvas.h"

namespace stickslip::drawing {

struct CurveStyle {
    Pen pen;
    const char* text;
};

CurveStyle curve_style(Curve::Kind kind);

/// The white edge that keeps a curve apart from the field beneath.
Pen halo_of(const Pen& pen);

}  // namespace stickslip::drawing
