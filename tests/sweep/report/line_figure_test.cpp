// Sets of gains in words.
#include "sweep/words/line_figure.h"

#include "analysis/results/text.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;

TEST_CASE("sets of gains read as words, without infinities", "[report]")
{
    const auto text = [](std::vector<Interval> list) {
        return intervals_text(list, Quantity::stiffness, Units(Motion::prismatic));
    };
    CHECK(text({}) == "none");
    CHECK(text({{0, infinity}}) == "all values");
    CHECK(text({{53.85e3, infinity}}) == "above 53.85 kN/m");
    CHECK(text({{0, 2e3}, {5e3, 8e3}}) == "below 2 kN/m, from 5 kN/m to 8 kN/m");
    // a window narrower than the printed digits is stated with digits that show its width
    CHECK(text({{2027.38, 2027.41}, {5e3, 8e3}}) == "from 2.02738 kN/m to 2.02741 kN/m, from 5 kN/m to 8 kN/m");
}

TEST_CASE("two theories whose edges read the same differ nowhere", "[report]")
{
    const auto differ = [](std::vector<Interval> list) {
        return that_read_apart(std::move(list), Quantity::stiffness, Units(Motion::prismatic)).size();
    };
    CHECK(differ({{2027.38, 2027.3801}}) == 0);
    CHECK(differ({{2027.38, 2027.3801}, {87.6e3, 200e9}}) == 1);
    CHECK(differ({{0, 2e3}, {5e3, infinity}}) == 2);
}

TEST_CASE("a smoothed line has samples where it is steep and where it ends", "[report]")
{
    // ln y falls by 100 from 1 to e, where it ends; before and behind it is flat
    const auto y = [](double x) { return x < 1 ? 1 : x > std::exp(1.0) ? missing : std::exp(-100 * std::log(x)); };
    LineChart::Line line;
    for (int i = -4; i <= 8; ++i) line.x.push_back(std::exp(0.5 * i)), line.y.push_back(y(line.x.back()));
    smooth(line, y, 1, 8);
    REQUIRE(std::is_sorted(line.x.begin(), line.x.end()));
    for (std::size_t i = 1; i < line.x.size(); ++i) {
        CHECK((std::isnan(line.y[i]) || line.y[i] == y(line.x[i])));
        if (line.y[i] > 0 && line.y[i - 1] > 0) CHECK(std::abs(std::log(line.y[i] / line.y[i - 1])) <= 1);
        if (std::isnan(line.y[i]) && !std::isnan(line.y[i - 1])) CHECK(std::log(line.x[i] / line.x[i - 1]) < 0.01);
    }
    CHECK(line.x.size() < 180);  // the flat parts are left as they were
}
