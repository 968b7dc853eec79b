#include "render/drawing/colour_map.h"
#include "render/pictures/placement.h"
#include "render/pictures/signed_field.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace stickslip;
using namespace stickslip::drawing;

namespace {

Axis axis(std::vector<double> values, bool log)
{
    return {"a.b", "b", "b", Quantity::number, log, std::move(values)};
}

Grid grid(const Axis& x, const Axis& y)
{
    return {x, spanning(x.values, x.log), y, spanning(y.values, y.log)};
}

}  // namespace

TEST_CASE("interpolation is exact for a function that is linear in chart positions", "[field]")
{
    const Axis x = axis({1, 3, 10, 100}, true), y = axis({-1, 0, 4}, false);
    const Scale sx = spanning(x.values, true), sy = spanning(y.values, false);
    const Grid g = grid(x, y);
    std::vector<double> values;
    for (const double b : y.values)
        for (const double a : x.values) values.push_back(2 + 3 * sx.at(a) - 5 * sy.at(b) + 7 * sx.at(a) * sy.at(b));
    for (const double u : {0.0, 0.1, 0.2385, 0.5, 0.77, 1.0})
        for (const double v : {0.0, 0.2, 0.6, 1.0}) {
            const auto place = g.at(u, v);
            double value = 0, weight = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                value += place.weight[k] * values[place.node[k]];
                weight += place.weight[k];
            }
            CHECK(weight == Approx(1));
            CHECK(value == Approx(2 + 3 * u - 5 * v + 7 * u * v));
        }
}

TEST_CASE("axes must ascend; a single row or column is a chart too", "[field]")
{
    CHECK_THROWS_AS(grid(axis({1, 3, 2}, false), axis({0, 1}, false)), std::invalid_argument);
    CHECK_THROWS_AS(grid(axis({1, 1}, false), axis({0, 1}, false)), std::invalid_argument);
    const Grid g = grid(axis({5}, false), axis({0, 1}, false));
    CHECK(g.at(0.9, 0.1).nearest() == 0);
    CHECK(g.at(0.1, 0.9).nearest() == 1);
}

TEST_CASE("the colour scale is odd about zero and undone by its inverse", "[field]")
{
    const FieldScale scale = field_scale({-300, -2, 0, 1, 40, NAN});
    CHECK(scale.limit == 300);
    CHECK(scale.at(0) == 0.5);
    CHECK(scale.at(300) == Approx(1));
    CHECK(scale.at(-300) == Approx(0).margin(1e-12));
    for (const double v : {-120.0, -0.3, 2.0, 77.0}) {
        CHECK(scale.at(v) + scale.at(-v) == Approx(1));
        CHECK(scale.value(scale.at(v)) == Approx(v));
    }
    CHECK(field_scale({NAN, 0}).limit == 1);
}

TEST_CASE("colour bar marks keep their distance and tell the truth", "[field]")
{
    for (const double limit : {1e-3, 7.0, 274.0, 9e6}) {
        const FieldScale scale = field_scale({-limit, limit / 700, limit / 50, -limit / 3});
        const auto marks = field_marks(scale, 470);
        CHECK(marks.size() >= 7);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            CHECK(marks[i].position >= 0);
            CHECK(marks[i].position <= 1);
            for (std::size_t j = 0; j < i; ++j) CHECK(std::abs(marks[i].position - marks[j].position) * 470 >= 22);
        }
    }
}

TEST_CASE("pixels have the colour of their value, grey where there is none", "[field]")
{
    const Axis x = axis({0, 1}, false), y = axis({0, 1}, false);
    const FieldScale scale{1, 10};
    const Raster raster = field_raster(grid(x, y), {-10, NAN, -10, NAN}, scale, 4, 1);
    const Colour decays = from_hex(vik_table[0]);
    CHECK(raster.pixels[0] == decays.red);
    CHECK(raster.pixels[2] == decays.blue);
    CHECK(raster.pixels[3] == decays.red);  // left of the middle: what is known counts alone
    CHECK(raster.pixels[6] == no_value.red);
    CHECK(raster.pixels[11] == no_value.blue);
}

TEST_CASE("labels go where the room is and avoid what is there", "[placement]")
{
    const Rectangle box{0, 0, 400, 300};
    const Covers left_half = [](Point p) { return p.x < 200; };
    const auto place = roomiest_place(box, 60, 14, left_half, {});
    REQUIRE(place);
    CHECK(place->left + 30 == Approx(100).margin(13));
    CHECK(place->top + 7 == Approx(150).margin(60));
    CHECK_FALSE(roomiest_place(box, 220, 14, left_half, {}));
    CHECK_FALSE(roomiest_place(box, 60, 14, [](Point) { return false; }, {}));

    const Obstacles line{{{{0, 150}, {400, 150}}}, {}};
    const auto beside_line = roomiest_place(box, 60, 14, left_half, line);
    REQUIRE(beside_line);
    CHECK(line.touched(*beside_line) == 0);

    const Rectangle corner = place_beside({395, 5}, 50, 14, box, {});
    CHECK(corner.right() <= 400);
    CHECK(corner.top >= 0);
    const Obstacles above{{}, {{0, 0, 400, 140}}};
    CHECK(above.touched(place_beside({200, 150}, 50, 14, box, above)) == 0);
}
