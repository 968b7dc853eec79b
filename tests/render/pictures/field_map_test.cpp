#include "render/csv/csv.h"
#include "render/page/figure_data.h"
#include "render/render.h"
#include "tests/render/example_report.h"
#include "tests/render/well_formed.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <regex>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

FieldMap field()
{
    FieldMap map;
    map.title = "Amplitude";
    const auto grid = example::map(7, 5);
    map.x = grid.x;
    map.y = grid.y;
    map.name = "amplitude";
    map.quantity = Quantity::position;
    map.none = "no limit cycle";
    for (int i = 0; i < 35; ++i) map.values.push_back(i < 5 ? NAN : 1e-6 * i);
    return map;
}

Figure figure_of(Picture picture)
{
    Figure figure;
    figure.id = "field";
    figure.finding = "what it shows";
    figure.picture = std::move(picture);
    return figure;
}

}  // namespace

TEST_CASE("a field map draws numbers on every scale, and classes", "[pictures]")
{
    for (const auto scale : {FieldMap::Scale::linear, FieldMap::Scale::log, FieldMap::Scale::diverging}) {
        FieldMap map = field();
        map.scale = scale;
        const auto drawn = render(figure_of(map));
        CHECK(drawn.missing.empty());
        CHECK(oracle::fault_in_markup(drawn.svg).empty());
        CHECK(drawn.plot.width > 100);
    }
    FieldMap map = field();
    map.classes = {"as before", "changed, much"};
    for (std::size_t i = 0; i < map.values.size(); ++i) map.values[i] = i % 2;
    map.lines.push_back({"boundary", {2e3, 9e5}, {2, 900}, true});
    const auto drawn = render(figure_of(map));
    CHECK(oracle::fault_in_markup(drawn.svg).empty());
    CHECK_THAT(drawn.csv, Contains("\"changed, much\""));
    map.values[3] = 2;
    CHECK_THROWS_AS(render(figure_of(map)), std::invalid_argument);
    map.values.pop_back();
    CHECK_THROWS_AS(render(figure_of(map)), std::invalid_argument);
}

TEST_CASE("classes end at the lines of the map, not half way between its points", "[pictures]")
{
    FieldMap map = field();
    map.x = {"x", "x", "x", Quantity::number, false, {0, 1}};
    map.y = {"y", "y", "y", Quantity::number, false, {0, 1}};
    map.values = {0, 1, 0, 1};
    map.classes = {"left", "right"};
    map.lines = {{"boundary", {0.9, 0.9}, {0, 1}, false}};
    const auto bounded = render(figure_of(map));
    map.lines.clear();
    const auto unaided = render(figure_of(map));
    // ends of strokes, which only the hatching of the class to the right puts inside the chart
    const auto strokes = [](const RenderedFigure& f, double from, double to) {
        const std::regex pair("([0-9.]+)[, ]([0-9.]+)"), size("viewBox=\"0 0 ([0-9.]+) [0-9.]+\" width=\"([0-9.]+)\"");
        std::smatch found_size;
        REQUIRE(std::regex_search(f.svg, found_size, size));
        const double unit = std::stod(found_size[1]) / std::stod(found_size[2]);  // of coordinates, per pixel
        const auto within = [](double v, double low, double high) { return v > low && v < high; };
        int found = 0;
        for (std::sregex_iterator it(f.svg.begin(), f.svg.end(), pair), end; it != end; ++it)
            found += within(std::stod((*it)[1]) / unit, f.plot.left + from * f.plot.width,
                            f.plot.left + to * f.plot.width) &&
                     within(std::stod((*it)[2]) / unit, f.plot.top + 3, f.plot.top + f.plot.height - 3);
        return found;
    };
    CHECK(strokes(bounded, 0.45, 0.85) == 0);
    CHECK(strokes(bounded, 0.85, 0.99) > 10);
    CHECK(strokes(unaided, 0.45, 0.85) > 10);
}

TEST_CASE("a field without a single value is drawn, not refused", "[pictures]")
{
    FieldMap map = field();
    for (double& v : map.values) v = NAN;
    CHECK(render(figure_of(map)).missing.empty());
}

TEST_CASE("a picture becomes the same PNG every time", "[pictures]")
{
    const auto drawn = render(figure_of(field()));
    const auto once = png(drawn);
    CHECK(once.substr(1, 3) == "PNG");
    CHECK(once == png(drawn));
    CHECK(png(RenderedFigure{}).empty());
}

TEST_CASE("layers travel with the map, and must fit it", "[page]")
{
    StabilityMap map = example::map(6, 4);
    map.depth = {"control.V0", "V_{0}", "velocity", Quantity::velocity, true, {}};
    map.depth_value = 2;
    for (const double value : {1.0, 2.0, 4.0}) map.layers.push_back({value, map.abscissa, map.region, map.curves});
    const auto drawn = render(figure_of(map));
    const auto data = drawing::figure_data(figure_of(map), drawn);
    CHECK_THAT(data, Contains("\"depth\":{") && Contains("\"at\":1"));
    map.layers[1].abscissa.pop_back();
    CHECK_THROWS_AS(drawing::figure_data(figure_of(map), drawn), std::invalid_argument);
}

TEST_CASE("orbits wear no sample marks, and a legend that says nothing is left out", "[pictures]")
{
    LineChart chart;
    chart.x_label = {"x", "m"};
    chart.y_label = {"velocity V", "m/s"};
    chart.lines.push_back({"V", {0, 1, 2}, {0, 1, 0}});
    const auto alone = render(figure_of(chart));
    chart.lines[0].name = "last third";
    const auto named = render(figure_of(chart));
    CHECK(named.height > alone.height);
    LineChart orbit = chart;
    orbit.lines = {{"a", {}, {}}, {"b", {}, {}}};
    for (auto& line : orbit.lines)
        for (int i = 0; i < 4000; ++i) {
            line.x.push_back(std::cos(i * 0.02));
            line.y.push_back(std::sin(i * 0.02));
        }
    LineChart arcs = orbit;
    for (auto& line : arcs.lines) line.x.resize(150), line.y.resize(150);
    const auto shapes = [](const std::string& svg) {
        std::size_t n = 0;
        for (auto at = svg.find("fill=\"#0072b2\""); at != std::string::npos; at = svg.find("fill=\"#0072b2\"", at + 1))
            ++n;
        return n;
    };
    CHECK(shapes(render(figure_of(arcs)).svg) > 2);
    CHECK(shapes(render(figure_of(orbit)).svg) == 0);
}
