// Room for words on a picture that is already full of data.
#pragma once
#include "render/pictures/regions.h"

#include <optional>
#include <vector>

namespace stickslip::drawing {

/// What a label must not cover.
struct Obstacles {
    std::vector<Polyline> lines;
    std::vector<Rectangle> boxes;

    /// How many of them a rectangle would touch.
    int touched(const Rectangle& place) const;
};

/// The place for a label of the given size that lies deepest inside the covered part of `box`, away from all obstacles;
/// none where it would not fit.
std::optional<Rectangle> roomiest_place(const Rectangle& box, double width, double height, const Covers& covered,
                                        const Obstacles& obstacles);

/// The place beside a point that touches the fewest obstacles and stays inside `box`.
Rectangle place_beside(Point point, double width, double height, const Rectangle& box, const Obstacles& obstacles);

}  // namespace stickslip::drawing
