// The nearest boundary and the worst case against closed forms in the quasi-static limit of (35).
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/boundary/trace/locate.h"
#include "tests/analysis/loop/random_loop.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

/// Almost without inertia, so that k_cr = (B − A)/L: in logarithms the boundary is a plane.
Joint slow_joint(double k_p)
{
    Joint joint = example_joint(k_p, 0, 1e-3);
    joint.mechanism.inertia = 1e-9;
    return joint;
}

double change(const NearestBoundary& n, const std::string& path)
{
    for (const auto& m : n.moves)
        if (m.path == path) return m.to / m.from;
    return 0;
}

}  // namespace

TEST_CASE("the nearest point of a plane is shared evenly by the parameters that span it", "[boundary][nearest]")
{
    // ln k_cr − ln k_p = −ln 1.5; B − A and L each take half of it, A and the rest nothing
    const Joint joint = slow_joint(1.5 * 5e4);
    const auto nearest = nearest_boundary(joint, friction_coordinates(joint), {});
    REQUIRE(nearest.found);
    CHECK(nearest.stable);
    CHECK(nearest.distance == Approx(std::log(1.5) / std::sqrt(2.0)).epsilon(1e-5));
    CHECK(change(nearest, "friction.B") == Approx(std::sqrt(1.5)).epsilon(2e-3));
    CHECK(change(nearest, "friction.L") == Approx(1 / std::sqrt(1.5)).epsilon(2e-3));
    CHECK(change(nearest, "friction.A") == Approx(1).margin(3e-3));
    CHECK(signed_margin(nearest) > 0);
}

TEST_CASE("of given directions alone the nearest crossing is exact, and none beyond it is located",
          "[boundary][nearest]")
{
    // along (1, −1) of ln(B − A) and ln L the plane is nearer by √2 than along either
    const Joint joint = slow_joint(1.5 * 5e4);
    const std::vector<Coordinate> coordinates{{"friction.B", "friction.A"}, {"friction.L", ""}};
    NearestOptions options{.reach = 10, .rays = 12, .precision = 1e-4};
    options.along_starts_only = true;
    options.starts = {{1, -1}};
    const auto alone = nearest_boundary(joint, coordinates, options);
    REQUIRE(alone.found);
    CHECK(std::abs(alone.distance / (std::log(1.5) / std::sqrt(2.0)) - 1) < 1e-8);
    // seven rays more, of which each is looked along up to there and no further
    for (const auto& further : {std::vector<double>{1, 0}, {0, -1}, {-1, 0}, {0, 1}, {-1, 1}, {1, 1}, {-1, -1}})
        options.starts.push_back(further);
    const auto all = nearest_boundary(joint, coordinates, options);
    CHECK(all.distance == Approx(alone.distance).epsilon(1e-12));
    CHECK(all.evaluations - alone.evaluations < 7 * 6);
    options.starts = {{-1, 1}};
    CHECK_FALSE(nearest_boundary(joint, coordinates, options).found);
}

TEST_CASE("what nature may change is the law, the inertia and the velocity", "[boundary][nearest]")
{
    std::vector<std::string> names;
    for (const auto& c : natural_coordinates(slow_joint(5e4)))
        names.push_back(c.path + (c.less.empty() ? "" : "-" + c.less));
    CHECK(names ==
          std::vector<std::string>{"joint.inertia", "control.V0", "friction.A", "friction.B-friction.A", "friction.L"});
}

TEST_CASE("scales weigh the parameters", "[boundary][nearest]")
{
    // min q_1² + q_2² with s_1 q_1 + s_2 q_2 = ln 1.5: distance ln 1.5/√(s_1² + s_2²)
    const Joint joint = slow_joint(1.5 * 5e4);
    const auto nearest =
        nearest_boundary(joint, {{"friction.B", "friction.A", 0.1}, {"friction.L", "", 0.4}}, {.reach = 10});
    CHECK(nearest.distance == Approx(std::log(1.5) / std::hypot(0.1, 0.4)).epsilon(1e-5));
}

TEST_CASE("an unstable joint has a negative margin to the same boundary", "[boundary][nearest]")
{
    const Joint joint = slow_joint(5e4 / 1.5);
    const auto nearest = nearest_boundary(joint, friction_coordinates(joint), {});
    CHECK_FALSE(nearest.stable);
    CHECK(signed_margin(nearest) == Approx(-std::log(1.5) / std::sqrt(2.0)).epsilon(1e-5));
}

TEST_CASE("with inertia the nearest point is stationary on the boundary", "[boundary][nearest]")
{
    const Joint joint = example_joint(8e4, 10, 1e-3);
    const auto coordinates = natural_coordinates(joint);
    const auto nearest = nearest_boundary(joint, coordinates, {});
    REQUIRE(nearest.found);
    std::vector<double> q;
    for (const double d : nearest.direction) q.push_back(d * nearest.distance);
    const auto at = [&](const std::vector<double>& p) {
        return instability(moved(joint, coordinates, p), Curve::Kind::state_variable);
    };
    // q is normal to the boundary: along it the gradient of the measure points
    std::vector<double> gradient;
    for (std::size_t i = 0; i < q.size(); ++i) {
        auto p = q, m = q;
        p[i] += 1e-5, m[i] -= 1e-5;
        gradient.push_back((at(p) - at(m)) / 2e-5);
    }
    double dot = 0, gg = 0, qq = 0;
    for (std::size_t i = 0; i < q.size(); ++i)
        dot += gradient[i] * q[i], gg += gradient[i] * gradient[i], qq += q[i] * q[i];
    CHECK(dot / std::sqrt(gg * qq) > 0.9999);
    CHECK(std::abs(at(q)) < 1e-6 * std::sqrt(gg));
}

TEST_CASE("along the velocity a sampled loop around delayed friction changes sides where its margin says",
          "[boundary][nearest][slow]")
{
    // its growth has no number at some velocities: a search that ended there answered 1.826 for 1.767
    const Joint joint = samples::random_loop(33);
    const auto nearest = nearest_boundary(joint, {{"control.V0", ""}}, affordable_search(joint));
    REQUIRE(nearest.found);
    const auto side = [&](double share) {
        Joint beside = joint;
        beside.control.V0 *= std::pow(nearest.moves[0].to / nearest.moves[0].from, share);
        return is_stable(beside, Curve::Kind::state_variable);
    };
    CHECK(side(0.9999) == nearest.stable);
    CHECK(side(1.0001) == !nearest.stable);
}

TEST_CASE("parameters that are off by the tolerance, each in its worst direction, are at most the distance away",
          "[boundary][nearest]")
{
    const double d = std::log(1.5);
    for (const auto& coordinates :
         {std::vector<Coordinate>{{"friction.L", ""}}, {{"friction.B", "friction.A", 0.1}, {"friction.L", "", 0.4}}}) {
        const double each = tolerance_each(d, coordinates);
        double squares = 0;
        for (const auto& c : coordinates) squares += std::pow(std::log1p(-each) / c.scale, 2);
        CHECK(std::sqrt(squares) == Approx(d).epsilon(1e-12));
        CHECK(std::abs(std::log1p(each)) < std::abs(std::log1p(-each)));  // upwards is nearer
    }
}

TEST_CASE("no boundary within reach is said", "[boundary][nearest]")
{
    const Joint joint = slow_joint(5e6);
    const auto nearest = nearest_boundary(joint, friction_coordinates(joint), {});
    CHECK_FALSE(nearest.found);
    CHECK(nearest.stable);
    CHECK_THROWS_AS(nearest_boundary(joint, {{"friction.x", ""}}, {}), std::invalid_argument);
}

TEST_CASE("the worst case over a box is its worst corner, over an ellipsoid a tangent", "[boundary][nearest]")
{
    Uncertainty u;
    u.coordinates = {{"friction.B", "friction.A"}, {"friction.L", ""}};
    u.share = {0.1, 0.2};
    // the worst corner is B − A up and L down: k_cr 1.1/0.8 times the nominal one
    for (const double factor : {0.999, 1.001}) {
        const auto box = worst_case(slow_joint(5e4 * 1.1 / 0.8 * factor), u, Curve::Kind::state_variable);
        CHECK((box.instability < 0) == (factor > 1));
        CHECK(box.deviations[0] == Approx(0.1));
        CHECK(box.deviations[1] == Approx(-0.2));
    }
    u.shape = UncertaintyShape::ellipsoid;
    // the largest (1 + 0.1 cos a)/(1 + 0.2 sin a), found on a fine grid
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const double a = 2 * M_PI * i / 1e6;
        worst = std::max(worst, (1 + 0.1 * std::cos(a)) / (1 + 0.2 * std::sin(a)));
    }
    for (const double factor : {0.9995, 1.0005})
        CHECK((worst_case(slow_joint(5e4 * worst * factor), u, Curve::Kind::state_variable).instability < 0) ==
              (factor > 1));
}

TEST_CASE("the worst of an ellipsoid is that of dense samples of its surface", "[boundary][nearest]")
{
    // closed form with inertia: k_cr = ((B − A)/L)(1 + m V_0²/(L A))
    constexpr double V0 = 3e-3;
    const auto k_cr = [](double excess, double L, double A) { return excess / L * (1 + V0 * V0 / (L * A)); };
    Uncertainty u;
    u.coordinates = {{"friction.B", "friction.A"}, {"friction.L", ""}, {"friction.A", ""}};
    u.share = {0.1, 0.2, 0.3};
    u.shape = UncertaintyShape::ellipsoid;
    double worst = 0;
    constexpr int rings = 1200;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < 2 * rings; ++j) {
            const double polar = M_PI * i / rings, around = M_PI * j / rings;
            worst =
                std::max(worst, k_cr(0.5 * (1 + 0.1 * std::sin(polar) * std::cos(around)),
                                     1e-5 * (1 + 0.2 * std::sin(polar) * std::sin(around)), 1 + 0.3 * std::cos(polar)));
        }
    REQUIRE(worst > 1.3 * k_cr(0.5, 1e-5, 1));
    for (const double factor : {1 - 1e-4, 1 + 1e-4})
        for (const bool global : {true, false})
            CHECK(
                (worst_case(example_joint(factor * worst, 0, V0), u, Curve::Kind::state_variable, global).instability <
                 0) == (factor > 1));
}

TEST_CASE("the robustly stable set ends where the worst corner turns unstable", "[boundary][nearest]")
{
    Uncertainty u;
    u.coordinates = {{"friction.B", "friction.A"}, {"friction.L", ""}};
    u.share = {0.1, 0.2};
    Axis k_p, V;
    k_p.path = "control.k_p", k_p.log = true, k_p.values = {1e4, 1e6};
    V.path = "control.V0", V.log = true, V.values = {1e-4, 1e-2};
    BoundaryRequest request;
    request.following.guard = 6;
    const auto edge = follow_robust_boundary(slow_joint(6e4), k_p, V, u, request);
    REQUIRE(edge.pieces.size() == 1);
    for (const auto& p : edge.pieces[0].points) CHECK(p.x == Approx(5e4 * 1.1 / 0.8).epsilon(1e-6));
}

TEST_CASE("No nearest boundary lies at a number that a joint cannot have", "[boundary][nearest]")
{
    // stiction fades over the Stribeck velocity: slides smoothly only where static friction is less than it can be
    Joint joint = example_joint(2e4, 10, 1e-3);
    MaxwellSlip law;
    law.elements.push_back({1e5, 5}), law.elements.push_back({3e5, 3});
    law.viscous = 1, law.static_ratio = 1.1, law.stribeck_velocity = 1e-3, law.attraction = 30;
    joint.friction.law = law;
    const std::vector<Coordinate> ratio{{"friction.static_ratio", ""}};
    MovableJoint movable(joint, ratio);
    movable.at({std::log(1.05 / 1.1)});
    CHECK(movable.allowed());
    movable.at({std::log(0.9 / 1.1)});
    CHECK_FALSE(movable.allowed());
    const auto nearest = nearest_boundary(joint, ratio, {});
    CHECK(nearest.decided);
    for (const auto& m : nearest.moves) CHECK(m.to >= 1);
}
