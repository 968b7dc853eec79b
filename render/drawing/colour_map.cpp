#include "render/drawing/colour_map.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {

Colour sample(const ColourTable& table, double position)
{
    const double last = static_cast<double>(table.size() - 1);
    const double at = std::clamp(position, 0.0, 1.0) * last;
    const auto below = static_cast<std::size_t>(std::min(at, last - 1));
    const double share = at - static_cast<double>(below);
    const Colour a = from_hex(table[below]), b = from_hex(table[below + 1]);
    const auto mix = [share](std::uint8_t p, std::uint8_t q) {
        return static_cast<std::uint8_t>(std::lround(p + share * (q - p)));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Raster bar_colours(const ColourTable& table)
{
    Raster bar{1, static_cast<int>(table.size()), 3, {}};
    for (auto entry = table.rbegin(); entry != table.rend(); ++entry) {
        const Colour c = from_hex(*entry);
        bar.pixels.insert(bar.pixels.end(), {c.red, c.green, c.blue});
    }
    return bar;
}

}  // namespace stickslip::drawing
