// Arrays as text inside the page: little-endian, bytes of equal rank side by side, deflated, base64. Neighbouring
// results share their high bytes, so that a field shrinks to about half.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace stickslip::drawing {

std::string pack(const std::vector<double>& values);         ///< 8 bytes each
std::string pack_floats(const std::vector<double>& values);  ///< 4 bytes each, relative error 6e-8
/// 4 bytes each of which the last carries nothing: relative error 2^-16, two thirds of the room.
std::string pack_coarse(const std::vector<double>& values);
std::string pack(const std::vector<std::uint8_t>& values);

}  // namespace stickslip::drawing
