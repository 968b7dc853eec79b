#include "render/csv/csv.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace stickslip;
using drawing::csv;
using drawing::field;
using drawing::number;

TEST_CASE("numbers read back to the same bits", "[csv]")
{
    constexpr unsigned seed = 11;
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 2000; ++i) {
        const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 130);
        CHECK(std::stod(number(value)) == value);
    }
    CHECK(number(0.1) == "0.1");
    CHECK(number(NAN) == "nan");
    CHECK(number(-std::numeric_limits<double>::infinity()) == "-inf");
}

TEST_CASE("fields are quoted as RFC 4180 asks", "[csv]")
{
    CHECK(field("plain") == "plain");
    CHECK(field("a,b") == "\"a,b\"");
    CHECK(field("say \"x\"") == "\"say \"\"x\"\"\"");
    CHECK(field("two\nlines") == "\"two\nlines\"");
}

TEST_CASE("a map is one line a grid point, x running first", "[csv]")
{
    StabilityMap map;
    map.x = {"control.k_p", "k_{p}", "position gain", Quantity::stiffness, true, {10, 20}};
    map.y = {"control.k_v", "k_{v}", "velocity gain", Quantity::damping, false, {0, 0.5}};
    map.abscissa = {-1, 2.5, NAN, -4};
    map.region = {Region::stable, Region::unstable, Region::undecided, Region::memory_only};
    CHECK(csv(map) ==
          "control.k_p [N/m],control.k_v [N·s/m],spectral abscissa [1/s],region\n10,0,-1,stable\n20,0,2.5,unstable\n"
          "10,0.5,nan,undecided\n20,0.5,-4,memory-only\n");
}

TEST_CASE("lines stand one after the other", "[csv]")
{
    LineChart chart;
    chart.x_label = {"time t", "s"};
    chart.y_label = {"x_{1}, x_{2}", "m"};
    chart.lines = {{"V_{0}", {0, 1}, {2, 3}, false}, {"b", {0}, {4}, true}};
    CHECK(csv(chart) == "line,time t [s],\"x1, x2 [m]\"\nV0,0,2\nV0,1,3\nb,0,4\n");
}
