#include "render/drawing/polyline.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace stickslip::drawing;

namespace {

const Rectangle window{0, 0, 10, 10};

double distance(Point p, const Polyline& line)
{
    double least = INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double dx = line[i + 1].x - line[i].x, dy = line[i + 1].y - line[i].y, n = dx * dx + dy * dy;
        const double t =
            n == 0 ? 0 : std::min(1.0, std::max(0.0, ((p.x - line[i].x) * dx + (p.y - line[i].y) * dy) / n));
        least = std::min(least, std::hypot(p.x - line[i].x - t * dx, p.y - line[i].y - t * dy));
    }
    return least;
}

}  // namespace

TEST_CASE("lines are cut at the frame", "[polyline]")
{
    CHECK(clip({{-5, 5}, {15, 5}}, window) == std::vector<Polyline>{{{0, 5}, {10, 5}}});
    CHECK(clip({{1, 1}, {2, 2}, {3, 1}}, window) == std::vector<Polyline>{{{1, 1}, {2, 2}, {3, 1}}});
    CHECK(clip({{-1, 11}, {-1, 2}}, window).empty());
    CHECK(clip({{-6, 5}, {5, 16}}, window).empty());  // passes outside the corner (0, 10)
    CHECK(clip({{5, 5}, {5, 15}, {6, 15}, {6, 5}}, window) ==
          std::vector<Polyline>{{{5, 5}, {5, 10}}, {{6, 10}, {6, 5}}});
}

TEST_CASE("a point that is no number breaks the line", "[polyline]")
{
    CHECK(clip({{1, 1}, {2, 2}, {NAN, NAN}, {3, 3}, {4, 4}}, window) ==
          std::vector<Polyline>{{{1, 1}, {2, 2}}, {{3, 3}, {4, 4}}});
    CHECK(clip({{1, 1}, {INFINITY, 2}}, window).empty());
    CHECK(clip({{1, 1}}, window).empty());
}

TEST_CASE("thinning stays within its tolerance and keeps the ends", "[polyline]")
{
    constexpr unsigned seed = 7;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    Polyline line;
    for (int i = 0; i < 2000; ++i) line.push_back({0.3 * i, 100 * std::sin(0.01 * i) + noise(random)});
    const Polyline thinned = thin(line, 0.5);
    CHECK(thinned.size() < line.size());
    CHECK(thinned.front() == line.front());
    CHECK(thinned.back() == line.back());
    for (const Point& p : line) CHECK(distance(p, thinned) <= 0.5 + 1e-9);
}

TEST_CASE("a long record keeps its spikes", "[polyline]")
{
    Polyline line;
    for (int i = 0; i < 100000; ++i) line.push_back({i * 0.005, i == 54321 ? 80.0 : 0.0});
    const Polyline thinned = thin(line, 0.1);
    CHECK(thinned.size() < 20);
    CHECK(std::any_of(thinned.begin(), thinned.end(), [](Point p) { return p.y == 80; }));
}

TEST_CASE("a line that fills its area has no dashes, and is drawn in short strokes", "[polyline]")
{
    Polyline scribble;
    for (int i = 0; i < 10'000; ++i) scribble.push_back({i % 2 == 0 ? 0.0 : 300.0, 0.03 * i});
    CHECK(!shows_dashes(scribble, {6, 4}));
    CHECK(shows_dashes({{0, 0}, {600, 400}}, {6, 4}));
    CHECK(!shows_dashes({{0, 0}, {600, 400}}, {}));
    const auto pieces = strokes(scribble);
    CHECK(pieces.size() == 25);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        CHECK(pieces[i].size() <= 401);
        CHECK((i == 0 || pieces[i].front() == pieces[i - 1].back()));
    }
    CHECK(pieces.front().front() == scribble.front());
    CHECK(pieces.back().back() == scribble.back());
}

TEST_CASE("a series in time is one stroke", "[polyline]")
{
    Polyline series;
    for (int i = 0; i < 10'000; ++i) series.push_back({0.06 * i, i % 2 == 0 ? 0.0 : 300.0});
    CHECK(strokes(series) == std::vector<Polyline>{series});
}

TEST_CASE("dashes follow the arc length across corners", "[polyline]")
{
    const std::vector<Point> ends = dashes({{0, 0}, {5, 0}, {5, 10}}, {3, 1});
    // On: 0…3, 4…7, 8…11, 12…15; the corner lies at 5 and splits the second dash.
    const std::vector<Point> wanted{{0, 0}, {3, 0}, {4, 0}, {5, 0}, {5, 0}, {5, 2}, {5, 3}, {5, 6}, {5, 7}, {5, 10}};
    REQUIRE(ends.size() == wanted.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        CHECK(ends[i].x == Approx(wanted[i].x).margin(1e-12));
        CHECK(ends[i].y == Approx(wanted[i].y).margin(1e-12));
    }
    CHECK(dashes({{0, 0}, {5, 0}}, {}).empty());
}
