// Bytes for the web: pictures as PNG, binary as base64.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::drawing {

/// A raster, row by row from the top, 3 (RGB) or 4 (RGBA) bytes a pixel.
struct Raster {
    int width = 0, height = 0, channels = 3;
    std::vector<std::uint8_t> pixels;
};

/// Compressed PNG bytes of a raster. Throws std::runtime_error where the encoder fails.
std::string png(const Raster& raster);

/// RFC 4648 base64 with padding.
std::string base64(std::string_view bytes);

}  // namespace stickslip::drawing
