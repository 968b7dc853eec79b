// Noise against closed forms of white noise, and designs whose optimum is known.
#include "analysis/design/design.h"
#include "analysis/boundary/kinds/nearest.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

/// A mass on a spring and a damper, no memory.
LinearJoint plain(double m, double c, double k)
{
    LinearJoint j;
    j.inertia[0] = m;
    j.actuated[0] = 1;
    j.k_p = k;
    j.friction[0].f_v = c;
    return j;
}

Requirements noisy(double position = 1e-6)
{
    Requirements r;
    r.noise.position = position;
    r.noise.period = 1e-4;
    r.front_points = 5;
    return r;
}

}  // namespace

TEST_CASE("white position noise moves a damped mass as the fluctuation formula says", "[design]")
{
    // force noise of density S = σ² T k² moves m ẍ + c ẋ + k x by √(S/(2 c k)), samples short against the motion
    SensorNoise n;
    n.position = 2e-6, n.period = 1e-7;
    for (const double c : {3.0, 300.0}) {
        const auto j = plain(1, c, 1e4);
        CHECK(motion_noise(j, n) == Approx(2e-6 * std::sqrt(1e-7 * 1e4 / (2 * c))).epsilon(2e-4));
    }
    CHECK(std::isnan(motion_noise(plain(1, -1, 1e4), n)));
}

TEST_CASE("an own velocity sensor adds S_v = sigma_v^2 T k_v^2", "[design]")
{
    SensorNoise n;
    n.position = 0, n.velocity = 1e-3, n.period = 1e-7;
    auto j = plain(2, 50, 4e3);
    j.k_v = 30;
    CHECK(motion_noise(j, n) == Approx(1e-3 * 30 * std::sqrt(1e-7 / (2 * 80 * 4e3))).epsilon(2e-4));
}

TEST_CASE("effort noise of a differenced and filtered position is the sum over its impulse response", "[design]")
{
    SensorNoise n;
    n.position = 1e-6, n.period = 1e-3, n.filter = 4e-3;
    auto j = plain(1, 10, 2e4);
    j.k_v = 70;
    const double a = 1.0 / 5;
    double first = j.k_p, sum = 0, h = 0;
    // h_k of H = a (1 − z⁻¹)/T /(1 − (1 − a) z⁻¹)
    for (int k = 0; k < 400; ++k) {
        const double input = k == 0 ? 1 : k == 1 ? -1 : 0;
        h = (1 - a) * h + a * input / n.period;
        sum += std::pow((k == 0 ? first : 0) + j.k_v * h, 2);
    }
    CHECK(effort_noise(j, n) == Approx(1e-6 * std::sqrt(sum)).epsilon(1e-5));
    // own sensor: k_p² σ_x² + k_v² σ_v² a/(2 − a)
    n.velocity = 2e-4;
    CHECK(effort_noise(j, n) == Approx(std::hypot(2e4 * 1e-6, 70 * 2e-4 * std::sqrt(a / (2 - a)))).epsilon(1e-5));
}

TEST_CASE("a quiet velocity and a noisy position choose velocity feedback, and the other way round", "[design][slow]")
{
    const Joint joint = example_joint(6e4, 10, 1e-3);
    auto r = noisy();
    r.objective = DesignObjective::effort;
    r.margin = 0.2;
    r.noise.position = 1e-9, r.noise.velocity = 1e-3;
    const auto by_position = design_gains(joint, r, test::in_order);
    REQUIRE(by_position.feasible);
    r.noise.position = 1e-3, r.noise.velocity = 1e-9;
    const auto by_velocity = design_gains(joint, r, test::in_order);
    REQUIRE(by_velocity.feasible);
    CHECK(by_position.best.k_v < 1);
    CHECK(by_position.best.k_p > 5e4);
    CHECK(by_velocity.best.k_v > 500);
    CHECK(by_velocity.best.k_p < 1e3);
    CHECK(by_position.best.margin >= 0.2 - 1e-5);
    // velocity-only thinking never finds the first: it asks for k_v > 500 N·s/m whatever the sensors
    CHECK(by_position.velocity_only_found);
    CHECK(by_position.velocity_only.k_v > 500);
    CHECK(by_position.velocity_only.cost > 100 * by_position.best.cost);
}

TEST_CASE("with position feedback alone the optimum stands on the demanded margin", "[design][slow]")
{
    // almost no inertia: margin = ln(k_p L/(B − A))/√2, effort noise σ_x k_p is least on the constraint
    Joint joint = example_joint(6e4, 0, 1e-3);
    joint.mechanism.inertia = 1e-9;
    auto r = noisy();
    r.objective = DesignObjective::effort;
    r.margin = 0.2;
    r.noise.velocity = 1e3;  // a useless sensor
    const auto d = design_gains(joint, r, test::in_order);
    REQUIRE(d.feasible);
    CHECK(d.best.k_p == Approx(5e4 * std::exp(0.2 * std::sqrt(2.0))).epsilon(2e-3));
    CHECK(d.best.cost == Approx(1e-6 * d.best.k_p).epsilon(1e-2));
    REQUIRE(d.front.size() >= 4);
    for (const auto& c : d.front) CHECK(c.k_p == Approx(5e4 * std::exp(c.margin * std::sqrt(2.0))).epsilon(1e-2));
}

TEST_CASE("a requirement that cannot be met is named with what could be", "[design][slow]")
{
    Joint joint = example_joint(6e4, 0, 1e-3);
    joint.mechanism.inertia = 1e-9;
    auto r = noisy(1e-6);
    r.objective = DesignObjective::effort;
    r.margin = 0.2;
    r.noise.velocity = 1e3;
    // f_ss = 60 N and 3 σ_x k_p ≥ 3·1e-6·5e4·e^{0.2√2} = 0.199 N
    r.effort_limit = 60.1;
    const auto d = design_gains(joint, r, test::in_order);
    CHECK_FALSE(d.feasible);
    REQUIRE(d.requirements.size() == 2);
    CHECK(d.requirements[1].name == "effort_limit");
    CHECK(d.requirements[1].others_met);
    // the nearest to feasible gives up the limit only, and no more of it than it has to
    CHECK(d.best.margin >= 0.2 - 1e-4);
    CHECK(d.best.peak_effort == Approx(d.requirements[1].attainable).epsilon(1e-9));
    CHECK(d.steady_effort == Approx(60));
    CHECK(d.requirements[1].attainable == Approx(60 + 3e-6 * 5e4 * std::exp(0.2 * std::sqrt(2.0))).epsilon(1e-4));
    // and the margin that 60.1 N allow: 3e-6 k_p = 0.1
    CHECK(d.requirements[0].attainable == Approx(std::log(0.1 / 3e-6 / 5e4) / std::sqrt(2.0)).margin(2e-2));
}

TEST_CASE("a front holds no choice that another one beats in both", "[design][slow]")
{
    auto r = noisy();
    r.noise.position = 2e-7, r.noise.period = 1e-3, r.noise.filter = 2e-3;
    r.effort_limit = 80, r.margin = 1, r.least_velocity = 1e-9, r.k_p_low = 2e4;
    r.front_points = 12;  // of seven none is beaten; of twelve some are, before they are searched again
    r.uncertain = {{"friction.L", "", 0.2}, {"friction.B", "friction.A", 0.1}, {"friction.A", "", 0.1}};
    const auto d = design_gains(example_joint(6e4, 10, 1e-3), r, test::in_order);
    REQUIRE(d.feasible);
    REQUIRE(d.front.size() >= 4);
    for (std::size_t i = 1; i < d.front.size(); ++i) {
        CHECK(d.front[i].margin > d.front[i - 1].margin);
        CHECK(d.front[i].cost > d.front[i - 1].cost);
    }
}

TEST_CASE("a design under a sampled loop holds in that loop, and no gains of a grid beat it", "[design][slow]")
{
    Joint joint = example_joint(9e4, 10, 1e-3);
    joint.control.period = 1e-3;
    joint.control.delay = 1e-3;
    joint.control.velocity_estimate = {EstimateForm::backward_difference, 2e-3, 1};
    auto r = noisy();
    r.noise.position = 2e-7, r.noise.period = 1e-3, r.noise.filter = 2e-3;
    r.margin = 0.1, r.k_p_low = 2e4, r.k_p_high = 1e6;
    r.front_points = 2;
    const auto d = design_gains(joint, r, test::in_order);
    REQUIRE(d.feasible);
    Joint best = joint;
    best.control.k_p = d.best.k_p, best.control.k_v = d.best.k_v;
    CHECK(growth_rate(best) < 0);
    CHECK(d.best.margin >= r.margin * (1 - 1e-4));
    const auto range = gain_range(joint, r);
    int held = 0;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 6; ++k) {
            Joint there = joint;
            there.control.k_p = range.k_p.low * std::pow(range.k_p.high / range.k_p.low, i / 7.0);
            there.control.k_v = range.k_v.high * k / 25.0;
            if (!(growth_rate(there) < 0)) continue;
            const auto near = nearest_boundary(there, friction_coordinates(there), {});
            if (!(signed_margin(near) >= r.margin)) continue;
            const auto response = LoopResponse::of(there, Theory::state_variable);
            ++held;
            CHECK(loop_noise(there, *response, r.noise).motion >= d.best.motion_noise * (1 - 1e-3));
        }
    CHECK(held > 2);
    // the loop's own reading is the one that is noisy
    r.noise.period = 2e-3;
    CHECK_THROWS_AS(design_gains(joint, r, test::in_order), std::invalid_argument);
}

TEST_CASE("a margin that one pair of gains has is not denied", "[design][slow]")
{
    // at k_p = 65.8 kN/m and k_v = 419 N·s/m the distance is 0.548, and at 244 kN/m and 756 N·s/m 1.34
    for (const double margin : {0.5, 0.8}) {
        auto r = noisy();
        r.noise.period = 1e-3, r.margin = margin;
        const auto design = design_gains(ticked_joint(70e3, 1e-3), r, test::in_order);
        INFO(margin);
        CHECK(design.feasible);
        CHECK(design.best.margin > margin - 1e-6);
        CHECK(design.requirements[0].met);
        for (const auto& other : design.front)
            if (other.margin >= margin) CHECK(other.cost >= design.best.cost);
    }
}

TEST_CASE("a margin beyond a factor of ten is looked for as far as it is demanded", "[design][slow]")
{
    // almost no inertia: margin = ln(k_p L/(B − A))/√2, and k_p may grow by e^{√2·4} = 286
    Joint joint = example_joint(6e4, 0, 1e-3);
    joint.mechanism.inertia = 1e-9;
    auto r = noisy();
    r.objective = DesignObjective::effort;
    r.margin = 4;
    r.noise.velocity = 1e3;
    const auto d = design_gains(joint, r, test::in_order);
    REQUIRE(d.feasible);
    CHECK(d.best.k_p == Approx(5e4 * std::exp(4 * std::sqrt(2.0))).epsilon(2e-2));
    CHECK(d.margin_reach > 4);
}

TEST_CASE("noise beyond all numbers is answered at once, as no feasible design", "[design][slow]")
{
    auto r = noisy(1e300);
    const auto d = design_gains(example_joint(6e4, 10, 1e-3), r, test::in_order);
    CHECK(d.decided);
    CHECK_FALSE(d.feasible);
    CHECK_FALSE(std::isfinite(d.best.cost));
}

TEST_CASE("requirements that mean nothing are refused", "[design]")
{
    const Joint joint = example_joint(6e4, 0, 1e-3);
    CHECK_THROWS_AS(design_gains(joint, Requirements{}, test::in_order), std::invalid_argument);
    auto r = noisy();
    r.k_p_low = 2, r.k_p_high = 1;
    CHECK_THROWS_AS(design_gains(joint, r, test::in_order), std::invalid_argument);
    r = noisy();
    r.least_velocity = 2e-3;  // twice the commanded one
    CHECK_THROWS_AS(design_gains(joint, r, test::in_order), std::invalid_argument);
}

TEST_CASE("The peak effort of gains holds gravity where it pulls most", "[design][slow]")
{
    Joint joint = example_joint(6e4, 0, 1e-3);
    joint.mechanism.inertia = 1e-9;
    joint.load.gravity_amplitude = 20;
    auto r = noisy(1e-6);
    r.objective = DesignObjective::effort;
    r.noise.velocity = 1e3;
    r.effort_limit = 70;
    // 60 N of friction and 20 N of gravity: 70 N are not enough, whatever the noise
    const auto d = design_gains(joint, r, test::in_order);
    CHECK(d.steady_effort == Approx(80));
    CHECK_FALSE(d.feasible);
}
