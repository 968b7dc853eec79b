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
