// Where hunting begins and ends: the linear edge under dry friction, a fold with bristles.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/simulation/set_point/set_point.h"
#include "tests/analysis/boundary/axis.h"

using namespace stickslip;

namespace {

Joint held(const FrictionLaw& law)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.V0 = 0;
    joint.control.k_p = 100;
    joint.control.k_v = 20;
    joint.control.k_i = 100;
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("hunting with static friction ends where the loop is unstable", "[boundary][set-point]")
{
    BoundaryRequest request;
    request.kind = BoundaryKind::hunting;
    const auto ray = locate_boundaries(held(KineticStatic{1, 1.5}), axis("control.k_i", 10, 1e5, true), request);
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].value == Approx(20 * 100).epsilon(1e-5));  // Routh: k_v k_p = m k_i
    CHECK(ray.points[0].direction == -1);
    CHECK(ray.undecided == 0);
}

TEST_CASE("hunting ends where dead time makes the loop unstable", "[boundary][set-point][slow]")
{
    BoundaryRequest request;
    request.kind = BoundaryKind::hunting;
    request.scan = 8;
    request.precision = 1e-4;
    const auto joint = held(KineticStatic{1, 1.5});
    const auto ray = locate_boundaries(joint, axis("control.delay", 1e-2, 1, true), request);
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].direction == -1);
    // s³ + e^{−sτ}(20 s² + 100 s + 100) = 0 at s = iω: |20 s² + 100 s + 100| = ω³, and its phase gives τ
    double low = 1, high = 100;
    const auto open = [](double w) { return std::complex<double>(100 - 20 * w * w, 100 * w); };
    while (high - low > 1e-12 * high) {
        const double w = 0.5 * (low + high);
        (std::abs(open(w)) > w * w * w ? low : high) = w;
    }
    const double phase = std::arg(open(low) / std::complex<double>(0, low * low * low));
    CHECK(ray.points[0].value == Approx(phase / low).epsilon(1e-3));
}

TEST_CASE("with LuGre hunting ends at a fold in the gain, on both sides as simulated", "[boundary][set-point][slow]")
{
    BoundaryRequest request;
    request.kind = BoundaryKind::hunting;
    request.precision = 1e-3;
    request.scan = 6;
    const auto joint = held(LuGre{1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3});
    const auto ray = locate_boundaries(joint, axis("control.k_p", 50, 2000, true), request);
    REQUIRE(ray.points.size() == 1);
    CHECK(ray.points[0].direction == -1);
    Joint below = joint, above = joint;
    below.control.k_p = 0.99 * ray.points[0].low, above.control.k_p = 1.01 * ray.points[0].high;
    CHECK(set_point(below).hunting == Hunting::yes);
    CHECK(set_point(above).hunting == Hunting::no);
}
