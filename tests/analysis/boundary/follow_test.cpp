// Following of level sets whose shape is known: turns, cusps, crossings, islands, borders.
#include "analysis/boundary/trace/follow.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

Axis linear_axis(double low, double high)
{
    Axis axis;
    axis.values = {low, high};
    return axis;
}

FollowedBoundary followed(std::function<double(double, double)> f, double half = 2, bool continuous = true,
                          double precision = 1e-9)
{
    Sides sides;
    sides.at = std::move(f);
    sides.continuous = continuous;
    sides.precision = precision;
    return follow_boundary(sides, linear_axis(-half, half), linear_axis(-half, half), {});
}

/// Length of all pieces.
double length(const FollowedBoundary& b)
{
    double sum = 0;
    for (const auto& piece : b.pieces) {
        for (std::size_t i = 1; i < piece.points.size(); ++i)
            sum += std::hypot(piece.points[i].x - piece.points[i - 1].x, piece.points[i].y - piece.points[i - 1].y);
        if (piece.last == CurveEnd::closed)
            sum += std::hypot(piece.points.front().x - piece.points.back().x,
                              piece.points.front().y - piece.points.back().y);
    }
    return sum;
}

template <class Residual>
double worst(const FollowedBoundary& b, Residual residual)
{
    double largest = 0;
    for (const auto& piece : b.pieces)
        for (const auto& p : piece.points) largest = std::max(largest, std::abs(residual(p.x, p.y)));
    return largest;
}

}  // namespace

TEST_CASE("a circle is followed once around, each point in its bracket", "[boundary][follow]")
{
    for (const bool continuous : {true, false}) {
        const auto circle =
            followed([](double x, double y) { return x * x + y * y - 1.3; }, 2, continuous, continuous ? 1e-9 : 1e-4);
        REQUIRE(circle.pieces.size() == 1);
        CHECK(circle.pieces[0].last == CurveEnd::closed);
        CHECK(length(circle) == Approx(2 * M_PI * std::sqrt(1.3)).epsilon(2e-3));
        CHECK(worst(circle, [](double x, double y) { return std::hypot(x, y) / std::sqrt(1.3) - 1; }) <
              (continuous ? 1e-9 : 1e-4));
        for (const auto& p : circle.pieces[0].points) {
            const double other = p.along_y ? p.x : p.y, exact = std::sqrt(1.3 - other * other);
            CHECK(p.at.converged);
            CHECK(p.at.low <= std::copysign(exact, p.at.value));
            CHECK(p.at.high >= std::copysign(exact, p.at.value));
            CHECK(p.at.direction == (p.at.value > 0 ? 1 : -1));
        }
        CHECK(circle.guard.unexplained == 0);
    }
}

TEST_CASE("a curve that turns back on its axis is one piece from border to border", "[boundary][follow]")
{
    // x = y³ − y: two turns in x
    const auto s = followed([](double x, double y) { return x - y * y * y + y; }, 1.5);
    REQUIRE(s.pieces.size() == 1);
    CHECK(s.pieces[0].first == CurveEnd::border);
    CHECK(s.pieces[0].last == CurveEnd::border);
    CHECK(worst(s, [](double x, double y) { return x - y * y * y + y; }) < 1e-8);
    double lowest = 9, highest = -9;
    for (const auto& p : s.pieces[0].points) lowest = std::min(lowest, p.y), highest = std::max(highest, p.y);
    // y³ − y = ±1.5 at y = ±1.43113
    CHECK(highest == Approx(1.43113).epsilon(1e-3));
    CHECK(lowest == Approx(-1.43113).epsilon(1e-3));
}

TEST_CASE("a cusp is turned at its tip", "[boundary][follow]")
{
    const auto cusp = followed([](double x, double y) { return y * y - x * x * x; });
    REQUIRE(cusp.pieces.size() == 1);
    CHECK(cusp.pieces[0].first == CurveEnd::border);
    CHECK(cusp.pieces[0].last == CurveEnd::border);
    double tip = 9, above = 0, below = 0;
    for (const auto& p : cusp.pieces[0].points) {
        tip = std::min(tip, p.x);
        above = std::max(above, p.y), below = std::min(below, p.y);
    }
    CHECK(std::abs(tip) < 0.02);
    CHECK(above == Approx(2));
    CHECK(below == Approx(-2));
}

TEST_CASE("corners are turned, crossings are passed", "[boundary][follow]")
{
    const auto corner = followed([](double x, double y) { return std::max(x - 0.3, y + 0.2); });
    REQUIRE(corner.pieces.size() == 1);
    CHECK(length(corner) == Approx(2.3 + 1.8).epsilon(1e-2));
    const auto lemniscate = followed([](double x, double y) {
        const double r = x * x + y * y;
        return r * r - 2 * (x * x - y * y);
    });
    CHECK(lemniscate.guard.unexplained == 0);
    CHECK(length(lemniscate) == Approx(5.24411510858 * std::sqrt(2.0)).epsilon(1e-2));
}

TEST_CASE("an island between the nodes of the guard is found by climbing", "[boundary][follow]")
{
    // radius 0.05 within cells of 0.25, centre far from every node
    const auto island = followed([](double x, double y) { return std::hypot(x - 0.61, y + 0.88) - 0.05; });
    REQUIRE(island.pieces.size() == 1);
    CHECK(island.guard.changes == 0);
    CHECK(island.guard.islands == 1);
    CHECK(island.pieces[0].last == CurveEnd::closed);
    CHECK(length(island) == Approx(2 * M_PI * 0.05).epsilon(0.02));
}

TEST_CASE("several pieces and what lies without a verdict", "[boundary][follow]")
{
    const auto two =
        followed([](double x, double y) { return std::min(std::hypot(x - 1, y) - 0.4, std::hypot(x + 1, y) - 0.5); });
    CHECK(two.pieces.size() == 2);
    CHECK(length(two) == Approx(2 * M_PI * 0.9).epsilon(1e-2));
    const auto half = followed([](double x, double y) { return x > 0.55 ? std::nan("") : y - 0.1 * x; });
    REQUIRE(half.pieces.size() == 1);
    CHECK(half.guard.undecided > 0);
    CHECK((half.pieces[0].first == CurveEnd::undecided || half.pieces[0].last == CurveEnd::undecided));
}

TEST_CASE("a coarse precision never costs more than a fine one", "[boundary][follow]")
{
    const auto wave = [](double x, double y) { return 0.3 * std::sin(x) - y + 1; };
    for (const bool continuous : {true, false}) {
        const auto fine = followed(wave, 2, continuous, 1e-6), coarse = followed(wave, 2, continuous, 0.1);
        CHECK(coarse.pieces.size() == 1);
        CHECK(coarse.evaluations <= fine.evaluations);
        CHECK(coarse.points() < 1.5 * fine.points());
    }
}

TEST_CASE("following takes few evaluations", "[boundary][follow]")
{
    int calls = 0;
    const auto line = followed([&](double x, double y) {
        ++calls;
        return std::sin(x) - y;
    });
    CHECK(calls == line.evaluations);
    CHECK(line.points() > 20);
    // foretold by those before: one on the curve, one across, and two for the bracket
    CHECK((calls - line.guard.nodes) < 4.5 * line.points());
}
