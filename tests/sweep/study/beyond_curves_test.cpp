// Which part of a chart is bistable, told from located curves and checked by simulation.
#include "sweep/study/beyond_curves.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/parameters.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "sweep/study/boundary_charts.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace stickslip;

namespace {

Axis axis(const char* path, double from, double to, bool log = false)
{
    Axis a;
    a.path = path;
    a.log = log;
    a.values = {from, to};
    return a;
}

void in_order(std::size_t n, const std::function<void(std::size_t)>& task)
{
    for (std::size_t i = 0; i < n; ++i) task(i);
}

/// A chart of linearly stable nodes with the design in its middle.
StabilityMap all_stable(int nodes)
{
    StabilityMap map;
    map.x = axis("control.k_p", 0, 1), map.y = axis("control.k_v", 0, 1);
    map.x.values.clear();
    for (int i = 0; i < nodes; ++i) map.x.values.push_back(static_cast<double>(i) / (nodes - 1));
    map.y.values = map.x.values;
    map.region.assign(map.x.values.size() * map.y.values.size(), Region::memory_only);
    map.design = {0.5, 0.5, true, Region::memory_only, -1};
    map.disagreement = 1;
    return map;
}

/// A closed fold around the middle, cycles inside of it.
FollowedBoundary ring(double radius)
{
    FollowedBoundary fold;
    fold.kind = BoundaryKind::fold;
    fold.x = axis("control.k_p", 0, 1), fold.y = axis("control.k_v", 0, 1);
    CurvePiece piece;
    constexpr int points = 60;
    for (int i = 0; i <= points; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.3) / points;
        CurvePoint p;
        p.x = 0.5 + radius * std::cos(angle), p.y = 0.5 + radius * std::sin(angle);
        p.along_y = std::abs(std::sin(angle)) > std::abs(std::cos(angle));
        // upwards and to the right the ring is left on its upper and right half
        p.at.direction = (p.along_y ? std::sin(angle) : std::cos(angle)) > 0 ? -1 : 1;
        piece.points.push_back(p);
    }
    piece.first = piece.last = CurveEnd::closed;
    fold.pieces.push_back(piece);
    return fold;
}

}  // namespace

TEST_CASE("what a closed fold holds is bistable, and nothing else", "[report][boundary]")
{
    constexpr double radius = 0.3;
    auto map = all_stable(41);
    mark_bistable(map, {ring(radius)});
    for (std::size_t i = 0; i < map.region.size(); ++i) {
        const double x = map.x.values[i % 41], y = map.y.values[i / 41], away = std::hypot(x - 0.5, y - 0.5);
        if (std::abs(away - radius) < 0.005) continue;  // the ring is a polygon
        INFO(x << ", " << y);
        CHECK((map.region[i] == Region::bistable) == (away < radius));
    }
    CHECK(map.design.region == Region::bistable);
    CHECK(share_of_area(map, Region::bistable) == Approx(std::numbers::pi * radius * radius).margin(0.02));
    CHECK(map.disagreement == Approx(1 - share_of_area(map, Region::bistable)));
}

TEST_CASE("a fold that was lost on its way marks nothing", "[report][boundary]")
{
    auto fold = ring(0.3);
    fold.pieces[0].points.resize(20);
    fold.pieces[0].last = CurveEnd::lost;
    auto map = all_stable(21);
    mark_bistable(map, {fold});
    CHECK(share_of_area(map, Region::bistable) == 0);
    CHECK(map.design.region == Region::memory_only);
}

TEST_CASE("the strip between linear boundary and fold is bistable where simulation says so", "[report][boundary]")
{
    auto joint = example_joint(2.2e4, 47.5, 1e-2);
    BoundaryRequest request;
    request.kind = BoundaryKind::fold;
    const auto fold =
        follow_boundaries(joint, axis("control.k_p", 5e3, 5e4, true), axis("control.k_v", 44, 52), request);
    auto map = stability_under(joint, fold.x, fold.y, in_order);
    mark_bistable(map, {fold});
    CHECK(map.design.region == Region::bistable);
    constexpr unsigned seed = 7;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    int bistable = 0, other = 0;
    while (bistable < 6 || other < 6) {
        const std::size_t node = std::uniform_int_distribution<std::size_t>(0, map.region.size() - 1)(random);
        if (map.region[node] == Region::unstable) continue;
        const bool marked = map.region[node] == Region::bistable;
        if ((marked ? bistable : other)++ >= 6) continue;
        number_at(joint, "control.k_p") = map.x.values[node % map.x.values.size()];
        number_at(joint, "control.k_v") = map.y.values[node / map.x.values.size()];
        INFO("k_p = " << joint.control.k_p << ", k_v = " << joint.control.k_v);
        CHECK((nonlinear_verdict(joint, {}).region == NonlinearRegion::bistable) == marked);
    }
}
