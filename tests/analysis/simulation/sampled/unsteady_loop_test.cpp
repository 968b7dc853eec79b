// Forces that change with position or time, about sliding that would be steady without them: against the forced
// response in closed form.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/sampled/unsteady_terms.h"
#include "analysis/stability/verdict.h"

#include <cmath>
#include <complex>

using namespace stickslip;

namespace {

constexpr double mass = 2, k_p = 8e3, k_v = 40, viscous = 20, V0 = 0.02;

Joint sliding()
{
    Joint joint;
    joint.mechanism.inertia = mass;
    joint.control.k_p = k_p, joint.control.k_v = k_v, joint.control.V0 = V0;
    joint.friction.law = CoulombViscous{.coulomb = 5, .viscous = viscous};
    return joint;
}

/// Of the position, per force at this frequency.
double response(double omega)
{
    return 1 / std::abs(std::complex<double>(k_p - mass * omega * omega, (k_v + viscous) * omega));
}

}  // namespace

TEST_CASE("unsteady: a periodic force moves a joint that slides by its forced response", "[sampled][unsteady]")
{
    Joint joint = sliding();
    const double omega = 30;
    joint.load.disturbance = {.amplitude = 2, .frequency = omega};
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.region == NonlinearRegion::stable);
    CHECK(verdict.jitter == Approx(2 * response(omega)).epsilon(0.01));
    CHECK(verdict.velocity_max - V0 == Approx(2 * omega * response(omega)).epsilon(0.01));
    CHECK(V0 - verdict.velocity_min == Approx(2 * omega * response(omega)).epsilon(0.01));
    CHECK(verdict.growth_rate == Approx(linear_verdict(joint).state_variable.spectral_abscissa).epsilon(1e-3));
}

TEST_CASE("unsteady: a force beyond what leaves the velocity its sign brings the joint to rest", "[sampled][unsteady]")
{
    const double omega = 30, least = V0 / (omega * response(omega));
    for (const double part : {0.9, 1.2}) {
        Joint joint = sliding();
        joint.load.disturbance = {.amplitude = part * least, .frequency = omega};
        const auto verdict = nonlinear_verdict(joint, {});
        INFO(part);
        CHECK((verdict.outcome == Outcome::stable_sliding) == (part < 1));
        CHECK(verdict.noise_suffices == (part > 1));
        if (part > 1) CHECK(verdict.period == Approx(2 * std::acos(-1.0) / omega).epsilon(0.01));
    }
}

TEST_CASE("unsteady: cogging moves a joint as the force that it is at this velocity", "[sampled][unsteady]")
{
    Joint joint = sliding();
    const double periods = 400, omega = periods * V0;
    joint.load.cogging.amplitude = 0.5, joint.load.cogging.periods = periods;
    CHECK(longest_change(joint) == Approx(2 * std::acos(-1.0) / omega));
    std::vector<PointResult> points(1);
    nonlinear_points({&joint, 1}, {}, points);
    CHECK(points[0].outcome == Outcome::stable_sliding);
    const auto verdict = nonlinear_verdict(joint, {});
    // its slope is a spring of up to 200 N/m beside k_p
    CHECK(verdict.jitter == Approx(0.5 * response(omega)).epsilon(0.03));
    CHECK(verdict.region == NonlinearRegion::stable);
}

TEST_CASE("unsteady: friction that grows with the effort carried slides steadily", "[sampled][unsteady]")
{
    Joint joint = sliding();
    joint.friction.load_coefficient = 0.2;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK_FALSE(changes_on_the_way(joint));
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.growth_rate == Approx(linear_verdict(joint).state_variable.spectral_abscissa).epsilon(1e-3));
}

TEST_CASE("unsteady: a vibration that the controller adds has no outcome, and says so", "[sampled][unsteady]")
{
    Joint trembling = sliding();
    trembling.control.period = 1e-3;
    trembling.control.dither = {.amplitude = 1, .frequency = 300};
    const auto verdict = nonlinear_verdict(trembling, {});
    CHECK(verdict.outcome == Outcome::undecided);
    CHECK(verdict.detail == Detail::place_or_time);
}
