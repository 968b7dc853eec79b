// The end of a surface that falls to zero between two nodes of its grid.
#include "render/pictures/surface_rim.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::drawing;

namespace {

/// One row of a gain that falls to zero at x = end, and does not exist beyond; two such rows.
CriticalGainSurface falling_to(double end, double height)
{
    CriticalGainSurface s;
    s.x.values = {1, 2, 3, 4, 5, 6};
    s.y.values = {1, 2};
    for (int row = 0; row < 2; ++row)
        for (const double x : s.x.values) s.z.push_back(x < end ? height * (end - x) : NAN);
    s.z[0] = 100 * height;  // so that the heights need a log scale
    return s;
}

}  // namespace

TEST_CASE("a node just before the surface's end is not drawn as a spike", "[picture]")
{
    const auto close = falling_to(5.001, 1e5);  // 100 at x = 5, 1.001e5 at x = 4
    CHECK(unresolved_rim(close) == std::vector<std::size_t>{4, 10});
    const auto drawn = drawn_heights(close);
    CHECK(std::isnan(drawn[4]));
    CHECK(drawn[3] == close.z[3]);
}

TEST_CASE("an end that the grid resolves is drawn whole", "[picture]")
{
    CHECK(unresolved_rim(falling_to(5.9, 1e5)).empty());  // 0.9e5 at x = 5, 1.9e5 at x = 4
}

TEST_CASE("a linear scale has a place for zero", "[picture]")
{
    auto surface = falling_to(5.3, 1e5);
    surface.z[0] = surface.z[1];
    CHECK_FALSE(needs_log_scale(surface.z));
    CHECK(unresolved_rim(surface).empty());
}

TEST_CASE("a low place away from holes is the surface's own", "[picture]")
{
    auto surface = falling_to(7, 1e5);
    surface.z[3] = 1;
    CHECK(needs_log_scale(surface.z));
    CHECK(unresolved_rim(surface).empty());
}
