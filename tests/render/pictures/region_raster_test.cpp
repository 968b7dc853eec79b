#include "render/pictures/region_raster.h"

#include <catch2/catch.hpp>

#include <random>

using namespace stickslip;
using namespace stickslip::drawing;

namespace {

Axis even(std::size_t count)
{
    Axis axis;
    for (std::size_t i = 0; i < count; ++i) axis.values.push_back(double(i) / double(count - 1));
    return axis;
}

/// Nodes right of the line from (0.2, 0) to (0.8, 1) are stable.
bool right_of_line(double x, double y)
{
    return x > 0.2 + 0.6 * y;
}

}  // namespace

TEST_CASE("without boundaries a place takes the verdict of the nearest node", "[regions]")
{
    const Axis x = even(2), y = even(2);
    const Grid grid(x, {0, 1}, y, {0, 1});
    const std::vector<Region> regions{Region::stable, Region::unstable, Region::stable, Region::unstable};
    const RegionRaster raster(grid, regions, {}, {100, 200, 50, 50});
    CHECK(raster.at({110, 225}) == Region::stable);
    CHECK(raster.at({140, 225}) == Region::unstable);
    CHECK(raster.at({100, 200}) == Region::stable);
    CHECK(raster.at({150, 250}) == Region::unstable);
}

TEST_CASE("regions end at the boundary, not half way between the nodes", "[regions]")
{
    // A coarse grid of 40 px cells: half a cell would be ten times the two pixels that are allowed here.
    const Axis x = even(11), y = even(11);
    const Grid grid(x, {0, 1}, y, {0, 1});
    std::vector<Region> regions;
    for (const double b : y.values)
        for (const double a : x.values) regions.push_back(right_of_line(a, b) ? Region::stable : Region::unstable);
    const Rectangle box{10, 20, 400, 400};
    const Polyline boundary{{10 + 0.2 * 400, 420}, {10 + 0.8 * 400, 20}};
    const RegionRaster raster(grid, regions, {boundary}, box);
    constexpr unsigned seed = 20240607;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const double a = place(random), b = place(random);
        const double pixels_off = 400 * (a - 0.2 - 0.6 * b) / std::hypot(1, 0.6);
        if (std::abs(pixels_off) < 2) continue;
        CAPTURE(seed, a, b, pixels_off);
        CHECK((raster.at({10 + 400 * a, 420 - 400 * b}) == Region::stable) == (pixels_off > 0));
    }
}
