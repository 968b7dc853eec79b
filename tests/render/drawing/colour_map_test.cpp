#include "render/drawing/colour_map.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip::drawing;

namespace {

struct Published {
    std::size_t entry;
    double red, green, blue;
};

void check(const ColourTable& table, const Published& p)
{
    INFO("entry " << p.entry);
    const Colour c = from_hex(table[p.entry]);
    CHECK(c.red == Approx(255 * p.red).margin(0.75));
    CHECK(c.green == Approx(255 * p.green).margin(0.75));
    CHECK(c.blue == Approx(255 * p.blue).margin(0.75));
}

/// CIE 1976 lightness of an sRGB colour (IEC 61966-2-1, D65).
double lightness(Colour c)
{
    const auto linear = [](double v) {
        v /= 255;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389.0 / 27;
}

}  // namespace

TEST_CASE("vik has the entries of the published table", "[colour]")
{
    // Crameri's vik.txt as fractions of one; the table in the program came from its 8-bit form.
    for (const Published& p :
         {Published{0, 0.001328, 0.069836, 0.379529}, Published{1, 0.002366, 0.076475, 0.383518},
          Published{64, 0.188606, 0.490191, 0.652599}, Published{127, 0.922285, 0.900367, 0.886911},
          Published{128, 0.926482, 0.897173, 0.879687}, Published{255, 0.350423, 6.1e-05, 0.030499}})
        check(vik_table, p);
}

TEST_CASE("viridis has the entries of matplotlib's table", "[colour]")
{
    for (const Published& p :
         {Published{0, 0.267004, 0.004874, 0.329415}, Published{64, 0.229739, 0.322361, 0.545706},
          Published{128, 0.127568, 0.566949, 0.550556}, Published{200, 0.440137, 0.811138, 0.340967},
          Published{255, 0.993248, 0.906157, 0.143936}})
        check(viridis_table, p);
}

TEST_CASE("the maps keep what they are chosen for", "[colour]")
{
    for (std::size_t i = 0; i + 1 < 256; ++i) {
        INFO("entry " << i);
        CHECK(lightness(from_hex(viridis_table[i + 1])) > lightness(from_hex(viridis_table[i])) - 0.25);
        const double step = lightness(from_hex(vik_table[i + 1])) - lightness(from_hex(vik_table[i]));
        CHECK((i < 126 ? step : -step) > -0.45);  // lightest in the middle, to a rounding of 8 bits
    }
}

TEST_CASE("a colour between two entries is mixed, beyond the ends it stays", "[colour]")
{
    CHECK(sample(vik_table, 0) == from_hex(vik_table[0]));
    CHECK(sample(vik_table, 1) == from_hex(vik_table[255]));
    CHECK(sample(vik_table, -3) == sample(vik_table, 0));
    CHECK(sample(vik_table, 7) == sample(vik_table, 1));
    ColourTable ramp{};
    ramp[1] = 0x0a1464;
    CHECK(sample(ramp, 0.5 / 255) == from_hex(0x050a32));
}
