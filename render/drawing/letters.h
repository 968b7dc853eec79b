// Letters of a typeface as outlines, straight from its file: at any size and angle, not fitted to pixels, and the same
// whatever was drawn before. VTK's own letters come out of a cache that forgets how far the pen moves in turned text.
#pragma once
#include <string>
#include <string_view>

namespace stickslip::drawing {

/// How far the pen moves along `text` (UTF-8), kerning included, for a font size of 1.
/// Throws std::runtime_error where the file holds no typeface.
double text_advance(const std::string& font_file, std::string_view text);

/// The outlines as data of an SVG path. The pen starts at the origin on the baseline and writes at `angle` [°],
/// counter-clockwise; y points down. Coordinates in the unit of `size`, with one decimal.
std::string outlines(const std::string& font_file, std::string_view text, double size, double angle);

}  // namespace stickslip::drawing
