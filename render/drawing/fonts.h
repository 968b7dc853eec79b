// Where the typeface is.
#pragma once
#include <string>
#include <vector>

namespace stickslip::drawing {

struct Fonts {
    std::string regular, bold;  ///< file names; empty when missing
    std::string missing;        ///< why there are none; empty when there are
};

/// The folders that are searched, in this order.
const std::vector<std::string>& font_folders();

/// Looks for DejaVu Sans in the given folders. Letters are drawn as outlines, so a picture needs the files only while
/// it is made.
Fonts find_fonts(const std::vector<std::string>& folders = font_folders());

}  // namespace stickslip::drawing
