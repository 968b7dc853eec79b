// Located boundaries against the closed form of (34)-(35).
#include "analysis/boundary/trace/locate.h"
#include "analysis/numerics/root.h"
#include "tests/analysis/friction/sample_laws.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <random>
#include <set>

using namespace stickslip;

namespace {

const Joint reference = example_joint(6e4, 0, 1e-3);

/// ((B − A − k_v V_0)/L)(1 + m V_0/(L C)), C = k_v + A/V_0, written out for the reference joint.
double closed_form(double k_v, double V0)
{
    return (0.5 - k_v * V0) / 1e-5 * (1 + V0 / (1e-5 * (k_v + 1 / V0)));
}

Axis axis(std::string path, double low, double high, int points)
{
    Axis a;
    a.path = std::move(path);
    a.log = true;
    for (int i = 0; i < points; ++i)
        a.values.push_back(low * std::pow(high / low, static_cast<double>(i) / (points - 1)));
    return a;
}

/// The reference contact on the link of two masses.
Joint two_masses()
{
    Joint joint = reference;
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = 0.5;
    joint.mechanism.link_inertia = 1;
    joint.mechanism.transmission.stiffness = 1e9;
    joint.frictions.motor.law = CoulombViscous{1, 0};
    joint.frictions.link.law = joint.friction.law;
    joint.friction = {};
    return joint;
}

}  // namespace

TEST_CASE("the side of a joint is the sign of its largest real part", "[boundary]")
{
    constexpr unsigned seed = 20261122;
    std::mt19937 random(seed);
    const auto log_uniform = [&random](double low, double high) {
        return std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
    };
    int stable = 0;
    for (int i = 0; i < 500; ++i) {
        Joint joint = i % 2 == 0 ? two_masses() : reference;
        joint.control.k_p = log_uniform(1e3, 1e7);
        joint.control.k_v = log_uniform(1, 1e4);
        joint.control.V0 = log_uniform(1e-5, 1e-1);
        for (const auto theory : {Curve::Kind::state_variable, Curve::Kind::velocity_only}) {
            CAPTURE(seed, i, joint.control.k_p, joint.control.k_v, joint.control.V0);
            CHECK(is_stable(joint, theory) == (instability(joint, theory) < 0));
            stable += *is_stable(joint, theory) ? 1 : 0;
        }
    }
    CHECK(stable > 200);
    CHECK(stable < 800);
    Joint at_rest = two_masses();
    at_rest.control.V0 = 0;
    CHECK_FALSE(is_stable(at_rest, Curve::Kind::state_variable).has_value());
}

TEST_CASE("the side of a joint with a delay is the sign of its largest real part", "[boundary]")
{
    // told by a count of roots, against the rightmost root
    constexpr unsigned seed = 20261128;
    std::mt19937 random(seed);
    const auto log_uniform = [&random](double low, double high) {
        return std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
    };
    const auto lagging = [&](Friction& friction) {
        friction.law = samples::time_lag(Stribeck{40, 120, 25, 0.015, 1}, log_uniform(1e-4, 1e-1));
    };
    int stable = 0;
    constexpr int joints = 60;
    for (int i = 0; i < joints; ++i) {
        Joint joint = i % 2 == 0 ? two_masses() : reference;
        lagging(i % 2 == 0 ? joint.frictions.link : joint.friction);
        joint.control.k_p = log_uniform(1e2, 1e6);
        joint.control.k_v = log_uniform(1, 1e4);
        joint.control.V0 = log_uniform(1e-4, 1e-1);
        const double growth = instability(joint, Curve::Kind::state_variable);
        CAPTURE(seed, i, joint.control.k_p, joint.control.k_v, joint.control.V0, growth);
        REQUIRE(std::isfinite(growth));
        CHECK(is_stable(joint, Curve::Kind::state_variable) == (growth < 0));
        stable += growth < 0;
    }
    CHECK(stable > joints / 10);
    CHECK(stable < joints - joints / 10);
}

TEST_CASE("a bracketed root is found to its precision", "[boundary]")
{
    const auto root = bracketed_root([](double x) { return std::cos(x) - x; }, 0, 1, 2, std::cos(2.0) - 2, 1e-14);
    CHECK(root.converged);
    CHECK(root.value == Approx(0.73908513321516064).epsilon(1e-14));
    CHECK(root.evaluations < 15);
    const auto flat =
        bracketed_root([](double x) { return std::pow(x - 0.3, 9); }, 0, std::pow(-0.3, 9), 1, std::pow(0.7, 9), 1e-12);
    CHECK(flat.value == Approx(0.3).epsilon(1e-11));
}

TEST_CASE("the gain boundary on a ray is the closed form over twelve orders of V_0", "[boundary]")
{
    for (double V0 = 1e-9; V0 < 2e-2; V0 *= 3.7) {
        Joint joint = reference;
        joint.control.V0 = V0;
        const auto found = locate_on_ray(joint, "control.k_p", 1, 1e9, true, Curve::Kind::state_variable);
        REQUIRE(found.size() == 1);
        CHECK(found[0].converged);
        CHECK(found[0].value == Approx(closed_form(0, V0)).epsilon(1e-9));
        CHECK(found[0].direction == -1);
    }
}

TEST_CASE("the velocity-only boundary on a ray is (B - A)/V_0", "[boundary]")
{
    const auto found = locate_on_ray(reference, "control.k_v", 1, 1e5, true, Curve::Kind::velocity_only);
    REQUIRE(found.size() == 1);
    CHECK(found[0].value == Approx(500).epsilon(1e-11));
}

TEST_CASE("every point of a chart's curve lies on the closed form, in one piece", "[boundary]")
{
    const auto curve = locate_over_chart(reference, axis("control.k_p", 1e3, 1e6, 20), axis("control.k_v", 1, 1e3, 20),
                                         Curve::Kind::state_variable);
    REQUIRE(curve.x.size() > 100);
    std::set<double> gains;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        REQUIRE_FALSE(std::isnan(curve.x[i]));
        CHECK(curve.x[i] == Approx(closed_form(curve.y[i], 1e-3)).epsilon(1e-8));
        if (i > 0) CHECK(curve.y[i] != curve.y[i - 1]);
        gains.insert(curve.y[i]);
    }
    CHECK(*gains.begin() == Approx(1));
    CHECK(*gains.rbegin() > 480);  // up to where k_cr leaves the chart near k_v = 500
}

TEST_CASE("a closed boundary comes back to its start", "[boundary]")
{
    // f_ss falls only around the Stribeck velocity: over (V_0, c2) the unstable set is a tongue, over (V_0, k_v) a bump
    Joint joint = reference;
    joint.friction.law = Stribeck{10, 5, 4, 1e-2, 2};
    const auto bump = locate_over_chart(joint, axis("control.V0", 1e-4, 1e-1, 30), axis("control.k_v", 1, 1e3, 30),
                                        Curve::Kind::velocity_only);
    REQUIRE(bump.x.size() > 20);
    for (std::size_t i = 0; i < bump.x.size(); ++i) {
        const double V = bump.x[i], u = V / 1e-2;
        CHECK(bump.y[i] == Approx(2 * 4 / 1e-2 * u * std::exp(-u * u) - 5).epsilon(1e-8));
    }
}

TEST_CASE("a margin is the distance to the nearest boundary", "[boundary]")
{
    const auto k_p = margin_along(reference, axis("control.k_p", 1e3, 1e6, 20));
    REQUIRE(k_p.found);
    CHECK(k_p.boundary == Approx(55000).epsilon(1e-9));
    const auto f0 = margin_along(reference, axis("friction.f0", 1, 100, 20));  // f_0 drops out of the linear theory
    CHECK_FALSE(f0.found);
}

TEST_CASE("several bodies have a velocity-only boundary, too", "[boundary]")
{
    // stiff: k_v > (B − A)/V_0 = 500 N·s/m as for one mass
    const auto found = locate_on_ray(two_masses(), "control.k_v", 10, 1e4, true, Curve::Kind::velocity_only);
    REQUIRE(found.size() == 1);
    CHECK(found[0].value == Approx(500).epsilon(1e-3));
    CHECK(found[0].direction == -1);
}
