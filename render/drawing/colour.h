// Colours as the painter takes them, and the four that the page may exchange for its dark theme.
#pragma once
#include <cstdint>

namespace stickslip::drawing {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    double opacity = 1;

    bool operator==(const Colour&) const = default;
};

constexpr Colour from_hex(std::uint32_t rgb, double opacity = 1)
{
    return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb),
            opacity};
}

/// Everything outside the data takes these four, and only these: page.css finds them by value in an inline SVG and
/// exchanges them where the reader prefers a dark page. What lies on the coloured field never uses them.
namespace theme {
constexpr Colour paper = from_hex(0xffffff);
constexpr Colour ink = from_hex(0x1b1f24);
constexpr Colour muted = from_hex(0x57606a);
constexpr Colour rule = from_hex(0xd8dee4);
}  // namespace theme

/// On the field itself, where the background does not follow the theme.
constexpr Colour field_ink = from_hex(0x000000);
constexpr Colour field_halo = from_hex(0xfefefe);

}  // namespace stickslip::drawing
