// Boundaries of joints, along axes and over charts, against the closed form of (34)-(35) and against each other.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/friction/time_lag.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

BoundaryRequest of(BoundaryKind kind)
{
    BoundaryRequest request;
    request.kind = kind;
    return request;
}

/// A = 1, B = 1.5, L = 10 µm, m = 1.
double closed_form(double k_v, double V0)
{
    return (0.5 - k_v * V0) / 1e-5 * (1 + V0 / (1e-5 * (k_v + 1 / V0)));
}

}  // namespace

TEST_CASE("the linear boundary over V_0 = 1e-6 … 1e-2 is the closed form to 1e-9", "[boundary][slow]")
{
    // 200 values, among them those around M = m V_0²/(L A) = 1e-4
    for (int i = 0; i <= 200; ++i) {
        const double V0 = 1e-6 * std::pow(1e4, i / 200.0);
        const auto ray = locate_boundaries(example_joint(5e4, 0, V0), axis("control.k_p", 1e3, 1e7),
                                           of(BoundaryKind::state_variable));
        REQUIRE(ray.points.size() == 1);
        CHECK(std::abs(ray.points[0].value / closed_form(0, V0) - 1) < 1e-9);
        CHECK(ray.points[0].low <= closed_form(0, V0) * (1 + 1e-12));
        CHECK(ray.points[0].high >= closed_form(0, V0) * (1 - 1e-12));
    }
}

TEST_CASE("one followed curve covers V_0 = 1e-6 … 1e-2", "[boundary]")
{
    const auto curve = follow_boundaries(example_joint(5e4, 0, 1e-3), axis("control.V0", 1e-6, 1e-2),
                                         axis("control.k_p", 1e4, 1e6), of(BoundaryKind::state_variable));
    REQUIRE(curve.pieces.size() == 1);
    for (const auto& p : curve.pieces[0].points) CHECK(std::abs(p.y / closed_form(0, p.x) - 1) < 1e-9);
    CHECK(curve.pieces[0].points.size() > 20);
}

TEST_CASE("a followed curve asks twenty times less a point than bisecting the rows of a grid", "[boundary]")
{
    constexpr int columns = 121, rows = 81;
    const auto request = of(BoundaryKind::state_variable);
    const Axis x = axis("control.k_p", 1e3, 1e6);
    for (const Axis& y : {axis("control.k_v", 1, 1e3), axis("control.V0", 1e-6, 1e-2)}) {
        const auto curve = follow_boundaries(example_joint(6e4, 10, 1e-3), x, y, request);
        // a row: every node, and each change halved until it is as narrow
        const double halvings = std::ceil(std::log2(std::log(1e3) / (columns - 1) / default_precision(request.kind)));
        int crossed = 0;
        for (int j = 0; j < rows; ++j) {
            Joint joint = example_joint(6e4, 10, 1e-3);
            number_at(joint, y.path) = y.values[0] * std::pow(y.values[1] / y.values[0], (j + 0.5) / rows);
            crossed += static_cast<int>(locate_boundaries(joint, x, request).points.size());
        }
        const double bisecting = rows * columns / static_cast<double>(crossed) + halvings;
        CHECK(curve.points() >= crossed);
        CHECK(curve.evaluations * 20 <= bisecting * curve.points());
    }
}

TEST_CASE("two states: the published critical stiffness", "[boundary]")
{
    // Gu, Rice, Ruina & Tse (1984): 0.0802755656 without inertia; the rest of it is the small mass
    Joint joint = dimensionless_joint(0.1, 1e-9, 1, 0);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B.push_back(0.84), law.L.push_back(1 / 0.048);
    const auto ray = locate_boundaries(joint, axis("control.k_p", 1e-3, 10), of(BoundaryKind::state_variable));
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value == Approx(0.0802755656).epsilon(2e-8));
}

TEST_CASE("a time lag leaves windows of stable gains, all of whose ends are found", "[boundary]")
{
    // m = 1, slope −100, 5 ms: 130112 … 794017 and 2624481 … 4616195 N/m
    Joint joint = example_joint(1e5, 0, 1e-3);
    TimeLag law;
    law.lag = 5e-3;
    Stribeck curve;
    curve.c0 = 1, curve.c1 = -100, curve.c2 = 0, curve.c3 = 1e-2;
    law.curve.law = curve;
    joint.friction.law = law;
    auto request = of(BoundaryKind::state_variable);
    request.scan = 60;
    const auto ray = locate_boundaries(joint, axis("control.k_p", 5e4, 5e6), request);
    REQUIRE(ray.points.size() == 4);
    const double published[] = {130112, 794017, 2624481, 4616195};
    for (int i = 0; i < 4; ++i) {
        CHECK(ray.points[i].value == Approx(published[i]).epsilon(1e-5));
        CHECK(ray.points[i].direction == (i % 2 == 0 ? -1 : 1));
    }
}

TEST_CASE("a window between two nodes of the scan is found by climbing", "[boundary]")
{
    // stable for one narrow range of V_0: the steep flank of a Stribeck curve, just compensated
    Joint joint = example_joint(1e3, 0, 1e-3);
    Stribeck law;
    law.c0 = 8, law.c1 = 0, law.c2 = 1, law.c3 = 1e-2;
    joint.friction.law = law;
    // hardest at V_cr = c3/√2 with √2 c2/c3 e^{-1/2} = 85.776
    joint.control.k_v = std::sqrt(2.0) * 100 * std::exp(-0.5) * (1 - 1e-6);
    auto request = of(BoundaryKind::velocity_only);
    request.scan = 37;
    const auto ray = locate_boundaries(joint, axis("control.V0", 1e-4, 1e-1), request);
    REQUIRE(ray.points.size() == 2);
    CHECK(ray.climbed > 0);
    for (const auto& p : ray.points) CHECK(p.value == Approx(1e-2 / std::sqrt(2.0)).epsilon(2e-3));
}

TEST_CASE("the least velocity is the lowest of the crossings", "[boundary]")
{
    // k_p = 60 kN/m, k_v = 0: k_cr rises with V_0, so sliding is stable at the least velocity of all; above, not
    CHECK(locate_boundaries(example_joint(6e4, 0, 1e-3), axis("control.V0", 1e-6, 1e-2), of(BoundaryKind::v_min))
              .points.empty());
    // k_p = 1 kN/m: stable where k_v V_0 exceeds nearly B − A = 0.5 N
    const auto ray =
        locate_boundaries(example_joint(1e3, 10, 1e-3), axis("control.V0", 1e-4, 1), of(BoundaryKind::v_min));
    REQUIRE(ray.points.size() == 1);
    CHECK(closed_form(10, ray.points[0].value) == Approx(1e3).epsilon(1e-6));
    CHECK(ray.points[0].direction == -1);
}

TEST_CASE("V_min lies above every window of smooth sliding", "[boundary]")
{
    // LuGre at this gain slides slowly and fast, and not between
    Joint joint = example_joint(6e4, 80, 7e-4);
    joint.friction.law = LuGre{1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3};
    const auto all = locate_boundaries(joint, axis("control.V0", 1e-5, 1e-1), of(BoundaryKind::state_variable));
    REQUIRE(all.points.size() == 2);
    CHECK(all.points[0].direction == 1);
    const auto least = locate_boundaries(joint, axis("control.V0", 1e-5, 1e-1), of(BoundaryKind::v_min));
    REQUIRE(least.points.size() == 1);
    CHECK(least.points[0].value == Approx(all.points[1].value));
    // a curve that rises in the middle alone, under negative damping: a window, and stick-slip above it
    joint.friction.law = Stribeck{8, 0, -1, 1e-2, 2};
    joint.control.k_v = -10;
    const auto window = locate_boundaries(joint, axis("control.V0", 1e-5, 1e-1), of(BoundaryKind::state_variable));
    REQUIRE(window.points.size() == 2);
    CHECK(window.points[0].direction == -1);
    CHECK(locate_boundaries(joint, axis("control.V0", 1e-5, 1e-1), of(BoundaryKind::v_min)).points.empty());
}

TEST_CASE("outcomes: the boundary lies between the linear one and the fold, and depends on the disturbance",
          "[boundary][outcome]")
{
    auto request = of(BoundaryKind::outcome);
    request.scan = 8;
    request.disturbance = {DisturbanceKind::position, 2e-5};
    const auto near = locate_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 1.5e4, 3e4), request);
    request.disturbance.size = 2e-4;
    const auto far = locate_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 1.5e4, 3e4), request);
    REQUIRE(near.points.size() == 1);
    REQUIRE(far.points.size() == 1);
    CHECK(near.points[0].precision() <= 1e-4);
    CHECK(near.points[0].value > 19449);
    CHECK(far.points[0].value > near.points[0].value);
    CHECK(far.points[0].value < 24860);
    CHECK(far.points[0].value > 24840);  // from 20 L: up to the fold
    CHECK(near.points[0].method == LocationMethod::bisection);
}

TEST_CASE("a ray says why a scanned point has no verdict", "[boundary][outcome]")
{
    auto request = of(BoundaryKind::outcome);
    request.scan = 4;
    request.disturbance = {DisturbanceKind::start, 1e-4};
    SECTION("the middle one of a range around rest, where the law has no meaning")
    {
        const auto ray =
            locate_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.V0", -1e-2, 1e-2, false), request);
        CHECK(ray.undecided > 0);
        CHECK(ray.reason == Reason::law_needs_motion);
    }
    SECTION("every one of a law that is linear by definition")
    {
        Joint joint = example_joint(2.2e4, 47.5, 1e-2);
        Kernel law;
        law.f0 = 60, law.f_v = 10, law.V_star = 1e-3;
        law.exponentials.push_back({100, 10});
        joint.friction.law = law;
        const auto ray = locate_boundaries(joint, axis("control.k_p", 1.5e4, 3e4), request);
        CHECK(ray.undecided == ray.nodes);
        CHECK(ray.reason == Reason::linear_only);
    }
}

TEST_CASE("a path that the joint lacks is refused", "[boundary]")
{
    CHECK_THROWS_AS(
        locate_boundaries(example_joint(1, 0, 1), axis("control.q", 1, 2), of(BoundaryKind::state_variable)),
        std::invalid_argument);
}

TEST_CASE("linear axes, ranges that begin at zero and negative ranges locate to 1e-9", "[boundary]")
{
    // velocity-only, (21): k_v V_0 = B − A, whatever k_p
    const Joint joint = example_joint(2e4, 400, 1e-3);
    const auto one = [&](BoundaryKind kind, const Axis& a, double expected) {
        const auto ray = locate_boundaries(joint, a, of(kind));
        CAPTURE(a.path, a.log, expected);
        REQUIRE(ray.points.size() == 1);
        CHECK(ray.points[0].converged);
        CHECK(std::abs(ray.points[0].value / expected - 1) < 1e-9);
        CHECK(ray.points[0].precision() < 1e-9);
        CHECK(ray.points[0].low <= expected * (1 + 1e-12));
        CHECK(ray.points[0].high >= expected * (1 - 1e-12));
    };
    const auto simple = BoundaryKind::velocity_only, memory = BoundaryKind::state_variable;
    for (const bool log : {false, true}) {
        const double low = log ? 1e-3 : 0;
        one(simple, axis("control.k_v", low, 1e4, log), 500);  // a node of the linear scan lies on it
        one(simple, axis("control.k_v", low, 1.1e4, log), 500);
        one(simple, axis("control.V0", low * 1e-3, 1e-2, log), 0.5 / 400);
        one(simple, axis("friction.A", low, 3, log), 1.5 - 400 * 1e-3);
        one(simple, axis("friction.B", low, 3, log), 1 + 400 * 1e-3);
        // k_cr(k_v) = 2e4: (500 − k)(k + 1100) = 200 (k + 1000)
        one(memory, axis("control.k_v", low, 1e4, log), (-800 + std::sqrt(800.0 * 800 + 4 * 350000)) / 2);
        one(memory, axis("control.k_p", low, 1e7, log), closed_form(400, 1e-3));
        one(memory, axis("control.k_p", log ? 1e-3 : 0, 2e10, log), closed_form(400, 1e-3));
    }
    // a rising steady curve bears negative feedback: k_v > −(A − B)/V_0
    Joint rising = example_joint(2e4, 0, 1e-3);
    std::get<RateAndState>(rising.friction.law).B[0] = 0.2;
    for (const double low : {-1000.0, -1600.0, -870.0}) {
        const auto ray = locate_boundaries(rising, axis("control.k_v", low, 500, false), of(simple));
        REQUIRE(ray.points.size() == 1);
        CHECK(ray.points[0].converged);
        CHECK(ray.points[0].value == Approx(-800).epsilon(1e-9));
        CHECK(ray.points[0].precision() < 1e-9);
    }
}

TEST_CASE("neutral sliding has no boundary but the one that it is", "[boundary]")
{
    Joint joint = example_joint(2e4, 0, 1e-3);
    joint.friction.law = Dahl{10.3, 1e5, 1};
    for (const auto kind : {BoundaryKind::velocity_only, BoundaryKind::state_variable}) {
        for (const char* path : {"control.k_p", "control.V0", "friction.coulomb", "friction.sigma0"}) {
            const auto ray = locate_boundaries(joint, axis(path, 1e-2, 1e2), of(kind));
            CAPTURE(path);
            CHECK(ray.points.empty());
            CHECK(ray.neutral_share == 1);
        }
        for (const double low : {-10.0, -7.3, 0.0}) {
            const auto ray = locate_boundaries(joint, axis("control.k_v", low, 10, false), of(kind));
            REQUIRE(ray.points.size() == 1);
            CHECK(std::abs(ray.points[0].value) < 1e-9);
            CHECK(ray.points[0].direction == -1);
        }
        const auto chart =
            follow_boundaries(joint, axis("control.k_p", 1e2, 1e6), axis("control.V0", 1e-5, 1), of(kind));
        CHECK(chart.pieces.empty());
    }
    CHECK(locate_boundaries(joint, axis("control.V0", 1e-5, 1), of(BoundaryKind::v_min)).points.empty());
}

TEST_CASE("a falling curve that fades away with velocity is no boundary", "[boundary]")
{
    // its slope at 14 c3 is 1e-82 of the greatest: neither sign of the growth means anything
    Joint joint = example_joint(6e4, 0, 1e-3);
    for (const bool delayed : {false, true}) {
        const Stribeck curve{10, 0, 0.1, 1e-3, 2};
        joint.friction.law = curve;
        TimeLag lag;
        lag.lag = 5e-3;
        lag.curve.law = curve;
        if (delayed) joint.friction.law = lag;
        const auto ray = locate_boundaries(joint, axis("control.V0", 1e-3, 1), of(BoundaryKind::velocity_only));
        CHECK(ray.points.empty());
        CHECK(ray.neutral_share > 0.1);
        CHECK(ray.stable_share == 0);
        // where the lag turns feeding into damping (k_p τ² = 5, beyond a quarter turn), that fades, too
        joint.control.k_p = delayed ? 2e5 : 6e4;
        CHECK(locate_boundaries(joint, axis("control.V0", 1e-3, 1), of(BoundaryKind::state_variable)).points.empty());
    }
}

TEST_CASE("the least velocity over a chart is that along each of its columns", "[boundary]")
{
    // LuGre slides at once slowly and fast: below V_min lies a curve at which sliding turns unstable
    Joint joint = example_joint(6e4, 80, 7e-4);
    joint.friction.law = LuGre{1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3};
    const Axis x = axis("control.k_p", 1e3, 1e6), y = axis("control.V0", 1e-5, 1e-1);
    const auto chart = follow_boundaries(joint, x, y, of(BoundaryKind::v_min));
    REQUIRE(chart.points() > 20);
    for (const auto& piece : chart.pieces)
        for (std::size_t i = 0; i < piece.points.size(); i += 10) {
            joint.control.k_p = piece.points[i].x;
            const auto ray = locate_boundaries(joint, y, of(BoundaryKind::v_min));
            REQUIRE(ray.points.size() == 1);
            CHECK(ray.points[0].value == Approx(piece.points[i].y).epsilon(1e-8));
        }
}

TEST_CASE("a boundary is found in a range of six hundred decades, along an axis and over a chart", "[boundary][slow]")
{
    const auto memory = of(BoundaryKind::state_variable);
    const double k_cr = closed_form(0, 1e-3);
    for (const double end : {1e100, 1e300, 1e307}) {
        CAPTURE(end);
        const auto gain = locate_boundaries(example_joint(6e4, 0, 1e-3), axis("control.k_p", 1 / end, end), memory);
        REQUIRE(gain.points.size() == 1);
        CHECK(gain.points[0].value == Approx(k_cr).epsilon(1e-9));
        // V_0² = L A (k_p L/(B − A) − 1)/m
        const auto velocity = locate_boundaries(example_joint(6e4, 0, 1e-3), axis("control.V0", 1 / end, end), memory);
        REQUIRE(velocity.points.size() == 1);
        CHECK(velocity.points[0].value == Approx(std::sqrt(2e-6)).epsilon(1e-9));
    }
    const auto chart = follow_boundaries(example_joint(6e4, 0, 1e-3), axis("control.k_p", 1e-300, 1e300),
                                         axis("control.k_v", 1, 1000), memory);
    REQUIRE(chart.pieces.size() == 1);
    // where the curve runs along an axis, k_p depends on the last digits of k_v: it is off by no more than those tell
    for (const auto& p : chart.pieces[0].points) {
        const double digits = 1e-11 * p.y, off = closed_form(p.y + digits, 1e-3) - closed_form(p.y - digits, 1e-3);
        if (p.x > 1e-3) CHECK(p.x == Approx(closed_form(p.y, 1e-3)).epsilon(1e-8).margin(std::abs(off)));
    }
    CHECK(chart.pieces[0].points.back().y + chart.pieces[0].points.front().y == Approx(501));
}

TEST_CASE("at the edge of an area of neutral sliding no boundary is drawn, through a line of it one is", "[boundary]")
{
    Joint joint = example_joint(2e4, 0, 1e-3);
    joint.friction.law = KineticStatic{10, 15};
    const Axis x = axis("control.k_p", 1e3, 1e9);
    for (const auto& [kind, theory] : {std::pair(BoundaryKind::velocity_only, Curve::Kind::velocity_only),
                                       std::pair(BoundaryKind::state_variable, Curve::Kind::state_variable)}) {
        // damping of 1e-16 N·s/m is none within rounding, 10 is some
        const Axis from_rounding = axis("control.k_v", 1e-16, 10);
        CHECK(follow_boundaries(joint, x, from_rounding, of(kind)).pieces.empty());
        CHECK(locate_over_chart(joint, x, from_rounding, theory).x.empty());
        // k_v = 0 lies on nodes of both meshes
        const Axis around_zero = axis("control.k_v", -6, 10, false);
        const auto curve = locate_over_chart(joint, x, around_zero, theory, 32);
        REQUIRE(!curve.x.empty());
        for (const double k_v : curve.y) CHECK(std::abs(k_v) < 1e-9);
        const auto followed = follow_boundaries(joint, x, around_zero, of(kind));
        REQUIRE(followed.pieces.size() == 1);
        for (const auto& p : followed.pieces[0].points) CHECK(std::abs(p.y) < 1e-9);
    }
}

TEST_CASE("What the rules of a joint refuse has no side, and their edge is no boundary", "[boundary]")
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    Neighbour n;
    n.inertia = 0.5, n.coupling = 0.3, n.k_p = 1e4, n.k_v = 100;
    joint.neighbour.push_back(n);
    const auto ray = locate_boundaries(joint, axis("neighbour.0.coupling", 0.1, 2), of(BoundaryKind::state_variable));
    CHECK(ray.points.empty());
    CHECK(ray.reason == Reason::impossible);
    // the mass matrix is positive definite below √(1 · 0.5) kg: ln(2/√0.5) of ln(2/0.1) lies above
    const double beyond = std::log(2 / std::sqrt(0.5)) / std::log(20.0);
    CHECK(static_cast<double>(ray.undecided) / ray.nodes == Approx(beyond).margin(0.01));
}
