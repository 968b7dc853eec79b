// Folds of limit cycles against published continuation results, and against plain simulation.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

BoundaryRequest folds()
{
    BoundaryRequest request;
    request.kind = BoundaryKind::fold;
    return request;
}

}  // namespace

TEST_CASE("the fold of the slip law lies where continuation and simulation put it", "[boundary][fold]")
{
    // m = 1, V_0 = 1e-2, k_v = 47.5: persists at 24840, decays at 24860 N/m; with continuation about 24849
    const auto ray = locate_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 5e3, 5e4), folds());
    REQUIRE(ray.points.size() == 1);
    const auto& fold = ray.points[0];
    CHECK(fold.value > 24840);
    CHECK(fold.value < 24860);
    CHECK(fold.value == Approx(24849).epsilon(5e-5));
    CHECK(fold.converged);
    CHECK(fold.precision() < 1e-6);
    CHECK(fold.method == LocationMethod::shooting);
    CHECK(fold.direction == -1);
}

TEST_CASE("the fold at beta = 1.5, M = 10 stands at 1.166 critical gains", "[boundary][fold]")
{
    // c = 0.94 (β − 1); k_cr = (β − 1 − c)(1 + M/(1 + c))
    const double c = 0.47, k_cr = 0.03 * (1 + 10 / 1.47);
    const auto ray =
        locate_boundaries(dimensionless_joint(k_cr, 10, 1.5, c), axis("control.k_p", k_cr / 5, k_cr * 5), folds());
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value / k_cr == Approx(1.166).epsilon(5e-4));
}

TEST_CASE("the ageing law's fold is found beside its linear boundary", "[boundary][fold]")
{
    // M = 10^-1.5: subcritical, fold at 1.00584 k_cr, far within one interval of the scan
    Joint joint = dimensionless_joint(1, std::pow(10, -1.5), 1.5, 0);
    Ageing law;
    law.f0 = 60, law.A = 1, law.V_star = 1;
    law.B.push_back(1.5), law.L.push_back(1);
    joint.friction.law = law;
    const double k_cr = 0.5 * (1 + std::pow(10, -1.5));
    const auto ray = locate_boundaries(joint, axis("control.k_p", k_cr / 5, k_cr * 5), folds());
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value / k_cr == Approx(1.00584).epsilon(1e-5));
}

TEST_CASE("a supercritical boundary has no fold", "[boundary][fold]")
{
    CHECK(locate_boundaries(example_joint(5e4, 0, 1e-3), axis("control.k_p", 1e4, 1e6), folds()).points.empty());
}

TEST_CASE("the fold is the same wall along any axis", "[boundary][fold]")
{
    const auto along_k_p = locate_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 5e3, 5e4), folds());
    REQUIRE(along_k_p.points.size() == 1);
    const double k_p = along_k_p.points[0].value;
    const auto along_k_v = locate_boundaries(example_joint(k_p, 45, 1e-2), axis("control.k_v", 40, 60, false), folds());
    REQUIRE(along_k_v.points.size() == 1);
    CHECK(along_k_v.points[0].value == Approx(47.5).epsilon(1e-6));
    const auto along_L = locate_boundaries(example_joint(k_p, 47.5, 1e-2), axis("friction.L", 3e-6, 3e-5), folds());
    REQUIRE(along_L.points.size() >= 1);
    CHECK(along_L.points[0].value == Approx(1e-5).epsilon(1e-6));
}

TEST_CASE("stick-slip coexists where the linear theory calls every gain stable", "[boundary][fold]")
{
    // k_v V_0 = 1.02 (B − A): within 1000…10000 N/m, and not far above
    const auto ray = locate_boundaries(example_joint(5e3, 51, 1e-2), axis("control.k_p", 2e3, 1e5), folds());
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value > 1e4);
    CHECK(ray.points[0].value < 2e4);
    NonlinearOptions options;
    for (const double share : {1 - 2e-4, 1 + 2e-4}) {
        const auto verdict = nonlinear_verdict(example_joint(share * ray.points[0].value, 51, 1e-2), options);
        CHECK((verdict.region == NonlinearRegion::bistable) == (share < 1));
    }
}

TEST_CASE("a fold is followed to where the linear boundary takes over", "[boundary][fold]")
{
    auto request = folds();
    request.following.guard = 4;
    const auto curve = follow_boundaries(example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 1e4, 6e4),
                                         axis("control.k_v", 42, 50.5, false), request);
    REQUIRE(curve.pieces.size() == 1);
    CHECK(curve.guard.unexplained == 0);
    const auto& piece = curve.pieces[0];
    CHECK((piece.first == CurveEnd::vanished) != (piece.last == CurveEnd::vanished));
    CHECK((piece.first == CurveEnd::border) != (piece.last == CurveEnd::border));
    CHECK(curve.precision() < 2e-6);
    for (const auto& p : piece.points) {
        // between the critical gain in closed form and twice that of the fold
        const double C = p.y + 100, k_cr = (0.5 - p.y * 1e-2) / 1e-5 * (1 + 1e-2 / (1e-5 * C));
        CHECK(p.x > k_cr);
    }
    // Jacobians carried along the curve: far fewer turns than Newton from scratch, and the same folds
    CHECK(curve.evaluations - curve.guard.evaluations < 7 * curve.points());
    int compared = 0;
    for (std::size_t i = 5; i < piece.points.size() && compared < 3; i += 25) {
        const auto& p = piece.points[i];
        if (p.y < 44) continue;
        request.scan = 2;
        const auto alone = p.along_y ? locate_boundaries(example_joint(p.x, p.y, 1e-2),
                                                         axis("control.k_v", p.y - 0.2, p.y + 0.2, false), request)
                                     : locate_boundaries(example_joint(p.x, p.y, 1e-2),
                                                         axis("control.k_p", 0.98 * p.x, 1.02 * p.x), request);
        REQUIRE(alone.points.size() == 1);
        INFO(p.at.low << " … " << p.at.high << " against " << alone.points[0].low << " … " << alone.points[0].high);
        // neither bracket may be so wide that it would meet the other one anyway
        CHECK(p.at.precision() < 2e-6);
        CHECK(alone.points[0].precision() < 2e-6);
        CHECK((p.at.low <= alone.points[0].high && alone.points[0].low <= p.at.high));
        ++compared;
    }
    CHECK(compared == 3);
    const double end = piece.last == CurveEnd::vanished ? piece.points.back().x : piece.points.front().x;
    const double k_v = piece.last == CurveEnd::vanished ? piece.points.back().y : piece.points.front().y;
    const double k_cr = (0.5 - k_v * 1e-2) / 1e-5 * (1 + 1e-2 / (1e-5 * (k_v + 100)));
    CHECK(end == Approx(k_cr).epsilon(2e-3));
}

namespace {

// With kinetic and static friction and k_v, a slip begins at rest with the spring beyond its steady stretch by
// (F_s − F_k − k_v V_0)/k_p and swings as a damped oscillator; the cycle ends where the least velocity of that swing is
// zero: below, the next stick erases what was before.
double least_velocity_of_slip(double k_p, double k_v, double V0, double excess)
{
    const double w0 = std::sqrt(k_p), decay = k_v / 2, w = std::sqrt(w0 * w0 - decay * decay);
    const double e0 = -(excess - k_v * V0) / k_p, a = e0, b = (-V0 + decay * e0) / w;
    const auto velocity = [&](double t) {
        return std::exp(-decay * t) * ((-decay * a + w * b) * std::cos(w * t) + (-decay * b - w * a) * std::sin(w * t));
    };
    // acceleration vanishes once a half turn: at the peak, then at the least
    double least = infinity;
    constexpr int steps = 200'000;
    const double turn = 2 * 3.14159265358979 / w;
    for (int i = steps / 4; i <= steps; ++i) least = std::min(least, velocity(turn * i / steps));
    return V0 + least;
}

Joint kinetic_static_joint(double k_p, double V0)
{
    Joint joint = dimensionless_joint(k_p, 1, 1.5, 5);
    joint.control.V0 = V0;
    joint.friction.law = KineticStatic{2, 3};
    return joint;
}

}  // namespace

TEST_CASE("the last cycle of kinetic and static friction grazes rest where its closed form does",
          "[boundary][fold][slow]")
{
    const auto along_V0 = locate_boundaries(kinetic_static_joint(1000, 0.02), axis("control.V0", 1e-3, 1), folds());
    REQUIRE(along_V0.points.size() == 1);
    const auto& v = along_V0.points[0];
    CHECK(least_velocity_of_slip(1000, 5, v.low, 1) < 0);
    CHECK(least_velocity_of_slip(1000, 5, v.high, 1) > 0);
    CHECK((v.converged && v.method == LocationMethod::bisection && v.direction == -1));
    const auto along_k_p = locate_boundaries(kinetic_static_joint(1000, 0.02), axis("control.k_p", 1e2, 1e6), folds());
    REQUIRE(along_k_p.points.size() == 1);
    CHECK(least_velocity_of_slip(along_k_p.points[0].low, 5, 0.02, 1) < 0);
    CHECK(least_velocity_of_slip(along_k_p.points[0].high, 5, 0.02, 1) > 0);
    CHECK(along_k_p.points[0].value == Approx(4084.6408394).epsilon(1e-4));
}

TEST_CASE("the fold of kinetic and static friction is followed over a chart", "[boundary][fold][slow]")
{
    auto request = folds();
    request.following.guard = 4;
    const auto curve = follow_boundaries(kinetic_static_joint(1000, 0.02), axis("control.k_p", 3e2, 1e4),
                                         axis("control.V0", 5e-3, 0.1), request);
    REQUIRE(curve.pieces.size() == 1);
    REQUIRE(curve.pieces[0].points.size() > 10);
    const auto least = [](const CurvePoint& p, double value) {
        return least_velocity_of_slip(p.along_y ? p.x : value, 5, p.along_y ? value : p.y, 1);
    };
    for (const auto& p : curve.pieces[0].points) {
        CHECK(least(p, p.at.low) < 0);
        CHECK(least(p, p.at.high) > 0);
    }
}

TEST_CASE("the fold of a sampled loop is its own, not that of the ideal one", "[boundary][fold][loop][slow]")
{
    // the paper's loop: 24 848.67 N/m; the linear boundary of this one: 32 220 N/m
    Joint joint = example_joint(2.2e4, 47.5, 1e-2);
    joint.control.period = 1e-4;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    const auto ray = locate_boundaries(joint, axis("control.k_p", 5e3, 2e5), folds());
    REQUIRE(ray.points.size() == 1);
    const auto& fold = ray.points[0];
    // an independent integration (Runge-Kutta in ln V, 1200 s): the cycle lasts at 34 132 and is gone at 34 134 N/m
    CHECK(fold.low < 34134);
    CHECK(fold.high > 34132);
    CHECK(fold.converged);
    CHECK(fold.method == LocationMethod::bisection);
    for (const double at : {fold.low, fold.high}) {
        joint.control.k_p = at;
        const auto region = nonlinear_verdict(joint, {}).region;
        CHECK(region == (at == fold.low ? NonlinearRegion::bistable : NonlinearRegion::stable));
    }
    CHECK(ray.narrowest_strip > 0);
}

TEST_CASE("an axis that brings a delay has no orbits of the ideal loop", "[boundary][fold][loop]")
{
    CHECK(has_smooth_orbits(example_joint(2.2e4, 47.5, 1e-2), {axis("control.k_p", 1, 2)}));
    CHECK_FALSE(has_smooth_orbits(example_joint(2.2e4, 47.5, 1e-2), {axis("control.delay", 0, 1e-3, false)}));
}
