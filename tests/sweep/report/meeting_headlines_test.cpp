// What located points and curves say of the design, and how their brackets are drawn.
#include "sweep/report/figures/meeting_headlines.h"
#include "sweep/study/boundary_charts.h"

#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

Axis gain()
{
    Axis a;
    a.path = "control.k_p", a.symbol = "k_{p}", a.name = "position gain";
    a.quantity = Quantity::stiffness;
    a.log = true;
    a.values = {5e3, 5e4};
    return a;
}

Axis damping()
{
    Axis a;
    a.path = "control.k_v", a.symbol = "k_{v}", a.name = "velocity gain";
    a.quantity = Quantity::damping;
    a.values = {40, 52};
    return a;
}

LocatedRay ray(BoundaryKind kind, double value, int direction)
{
    LocatedRay r;
    r.kind = kind;
    r.axis = gain();
    r.points.push_back({value, value, value, direction, true, 3, LocationMethod::interpolation});
    return r;
}

}  // namespace

TEST_CASE("a bracket wider than a line is drawn with both its ends, a narrow one not at all", "[report][boundary]")
{
    FollowedBoundary curve;
    curve.kind = BoundaryKind::outcome;
    curve.x = gain(), curve.y = damping();
    CurvePiece piece;
    for (const double width : {1e-6, 1.0, 1e-6}) {
        CurvePoint p;
        p.x = 1e4 * (1 + static_cast<double>(piece.points.size())), p.y = 46;
        p.at.value = p.y, p.at.low = p.y - width / 2, p.at.high = p.y + width / 2;
        piece.points.push_back(p);
    }
    curve.pieces.push_back(piece);
    const auto drawn = curve_with_brackets(curve);
    REQUIRE(drawn.x.size() == 3 + 3);
    CHECK(std::isnan(drawn.x[3]));
    CHECK(drawn.x[4] == 2e4);
    CHECK(drawn.x[5] == 2e4);
    CHECK(drawn.y[4] == 45.5);
    CHECK(drawn.y[5] == 46.5);
}

TEST_CASE("a ray tells how far each boundary is and on which side of it the design lies", "[report][boundary]")
{
    const auto design = example_joint(2.2e4, 47.5, 1e-2);  // 19 449 N/m: linear boundary; 24 849 N/m: fold
    const auto linear = ray(BoundaryKind::state_variable, 19449, -1), fold = ray(BoundaryKind::fold, 24849, -1);
    const auto cards = meeting_headlines(meetings_of(design, {linear, fold}, {}), Units(Motion::prismatic));
    REQUIRE(cards.size() == 2);
    CHECK(cards[0].value == "k_{p} −11.6 %");
    CHECK(cards[1].value == "k_{p} +13 %");
    CHECK(
        cards[1].meaning ==
        "from the design to the fold of limit cycles, where stick-slip cycles appear or vanish: 22 kN/m to 24.85 kN/m");
    CHECK(beyond_ray(design, fold));
    // cycles on the other side
    CHECK_FALSE(beyond_ray(design, ray(BoundaryKind::fold, 24849, 1)));
    CHECK_FALSE(beyond_ray(example_joint(2.6e4, 47.5, 1e-2), fold));
    // where sliding is unstable, or turns unstable on the way, nothing coexists with it
    CHECK_FALSE(beyond_ray(example_joint(1.8e4, 47.5, 1e-2), fold));
    CHECK_FALSE(beyond_ray(design, ray(BoundaryKind::outcome, 1.5e4, 1)));
    CHECK_FALSE(beyond_ray(design, linear));
    // no boundary, as there are cycles at every node
    auto throughout = fold;
    throughout.points.clear();
    throughout.nodes = 41, throughout.stable_share = 0;
    CHECK(beyond_ray(design, throughout));
    CHECK_FALSE(beyond_ray(example_joint(1.8e4, 47.5, 1e-2), throughout));
    throughout.stable_share = 1;
    CHECK_FALSE(beyond_ray(design, throughout));
}
