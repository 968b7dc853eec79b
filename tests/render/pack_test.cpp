#include "render/page/pack_arrays.h"

#include <zlib.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <random>

using namespace stickslip::drawing;

namespace {

/// RFC 4648, the other way.
std::string unbase64(const std::string& text)
{
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned value = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        value = value << 6 | static_cast<unsigned>(letters.find(c));
        bits += 6;
        if (bits >= 8) bytes += static_cast<char>(value >> (bits -= 8) & 255);
    }
    return bytes;
}

/// What the page's script does: inflate, then put the bytes of each number together again.
template <class Number>
std::vector<Number> unpack(const std::string& text, std::size_t count)
{
    const std::string packed = unbase64(text);
    std::string sorted(count * sizeof(Number), '\0');
    uLongf size = sorted.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(sorted.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()) == Z_OK);
    REQUIRE(size == sorted.size());
    std::string bytes(sorted.size(), '\0');
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < sizeof(Number); ++k) bytes[i * sizeof(Number) + k] = sorted[k * count + i];
    std::vector<Number> values(count);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

}  // namespace

TEST_CASE("packed numbers come back as they were, or as closely as promised", "[page]")
{
    std::mt19937 chance(11);
    std::uniform_real_distribution<double> exponent(-30, 30), sign(-1, 1);
    std::vector<double> values{0, -0.0, 1, INFINITY, -INFINITY, NAN};
    for (int i = 0; i < 1000; ++i) values.push_back(std::copysign(std::pow(10, exponent(chance)), sign(chance)));

    const auto exact = unpack<double>(pack(values), values.size());
    const auto floats = unpack<float>(pack_floats(values), values.size());
    const auto coarse = unpack<float>(pack_coarse(values), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) {
            CHECK(std::isnan(exact[i]));
            CHECK(std::isnan(floats[i]));
            CHECK(std::isnan(coarse[i]));
            continue;
        }
        CHECK(exact[i] == values[i]);
        CHECK(floats[i] == static_cast<float>(values[i]));
        if (std::isinf(values[i]) || values[i] == 0)
            CHECK(coarse[i] == static_cast<float>(values[i]));
        else
            CHECK(std::abs(coarse[i] / values[i] - 1) <= std::ldexp(1.01, -16));
    }
    const std::vector<std::uint8_t> bytes{0, 1, 255, 7};
    CHECK(unpack<std::uint8_t>(pack(bytes), 4) == bytes);
    CHECK_NOTHROW(pack(std::vector<double>{}));
}

TEST_CASE("a smooth field shrinks", "[page]")
{
    std::vector<double> field;
    for (int i = 0; i < 10000; ++i) field.push_back(std::sin(i * 1e-3));
    CHECK(pack_coarse(field).size() < 0.75 * pack_floats(field).size());
    CHECK(pack_floats(field).size() < 4 * 10000);
}
