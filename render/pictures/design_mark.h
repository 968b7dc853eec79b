// What every chart over two axes shows on its field: the design point, and curves cut to the frame.
#pragma once
#include "render/axes/frame.h"
#include "render/pictures/placement.h"

namespace stickslip::drawing {

constexpr double label_height = 14;

/// A black cross with a light rim.
void draw_cross(Canvas& canvas, Point at);

/// The design, drawn at the edge when it lies beyond. Returns what later labels must keep away from.
std::vector<Rectangle> draw_design(Canvas& canvas, const Frame& frame, const DesignPoint& design,
                                   const Obstacles& obstacles);

/// The pieces of a curve within the frame, without points that nobody would see; NaN separates pieces.
std::vector<Polyline> visible(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame);

}  // namespace stickslip::drawing
