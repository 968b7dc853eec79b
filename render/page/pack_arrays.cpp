#include "render/page/pack_arrays.h"

#include "render/drawing/encode.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

static_assert(std::endian::native == std::endian::little, "the page's data blocks are little-endian");

std::string deflated(const std::string& bytes)
{
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6);
    if (status != Z_OK) throw std::runtime_error("zlib could not compress the data of a figure");
    packed.resize(size);
    return packed;
}

template <class Number>
std::string packed(const std::vector<Number>& values)
{
    std::string sorted(values.size() * sizeof(Number), '\0');
    const char* bytes = reinterpret_cast<const char*>(values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < sizeof(Number); ++k) sorted[k * values.size() + i] = bytes[i * sizeof(Number) + k];
    return base64(deflated(sorted));
}

}  // namespace

std::string pack(const std::vector<double>& values)
{
    return packed(values);
}

std::string pack_floats(const std::vector<double>& values)
{
    return packed(std::vector<float>(values.begin(), values.end()));
}

std::string pack_coarse(const std::vector<double>& values)
{
    std::vector<float> rounded;
    rounded.reserve(values.size());
    for (const double value : values) {
        auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
        if (std::isfinite(value)) bits = (bits + 0x80u) & ~0xffu;
        rounded.push_back(std::bit_cast<float>(bits));
    }
    return packed(rounded);
}

std::string pack(const std::vector<std::uint8_t>& values)
{
    return packed(values);
}

}  // namespace stickslip::drawing
