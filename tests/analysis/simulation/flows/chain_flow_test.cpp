// Several bodies: the flow against the equations of motion of tests/oracles/motion.h, against finite differences,
// and in the limit of stiff springs against the single mass.
#include "analysis/simulation/flows/chain_flow.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/oracles/motion.h"

using namespace stickslip;

namespace {

Joint two_masses(double stiffness, double damping, FrictionLaw motor_law)
{
    Joint joint = example_joint(2e4, 0, 1e-3);
    auto& m = joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = 0.5, m.link_inertia = 1;
    m.transmission.stiffness = stiffness, m.transmission.damping = damping;
    joint.frictions.link = joint.friction;
    joint.frictions.motor.law = std::move(motor_law);
    return joint;
}

CoulombViscous coulomb(double level, double viscous)
{
    CoulombViscous law;
    law.coulomb = level, law.viscous = viscous;
    return law;
}

/// Accelerations and state rates of both formulations at random states.
void check_rates(const Joint& joint)
{
    const auto [flow, reason] = chain_flow(joint);
    REQUIRE(reason == Reason::none);
    const JointMotion motion(joint);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> spread(-0.5, 0.5);
    const auto steady = motion.steady(0);
    const FlowVector scale = flow.scale();
    for (int trial = 0; trial < 20; ++trial) {
        FlowVector y = flow.steady();
        for (int i = 0; i < flow.size(); ++i) y[i] += spread(random) * scale[i];
        std::vector<double> z(steady), rates(z.size());
        for (int i = 0; i < flow.bodies; ++i) {
            z[i] = steady[i] + y[i];
            z[flow.bodies + i] = flow.velocity(y, i);
        }
        for (int i = 2 * flow.bodies; i < flow.size(); ++i) z[i] = y[i];
        motion.rate(0, z.data(), rates.data());
        FlowVector rate;
        flow.rate(y, rate);
        for (int i = 0; i < flow.bodies; ++i) {
            const double v = flow.velocity(y, i), per_speed = flow.body[i].logarithmic ? 1 / v : 1;
            const double steepness = scale[flow.bodies + i] * 1e4;
            CHECK(rate[i] == Approx(v - flow.body[i].speed).margin(1e-15));
            CHECK(rate[flow.bodies + i] ==
                  Approx(rates[flow.bodies + i] * per_speed).epsilon(1e-9).margin(1e-9 * steepness));
        }
        for (int i = 2 * flow.bodies; i < flow.size(); ++i) CHECK(rate[i] == Approx(rates[i]).epsilon(1e-12));
    }
}

}  // namespace

TEST_CASE("chains move as the joint's equations of motion say", "[chain]")
{
    Joint joint = two_masses(1e6, 50, coulomb(2, 10));
    check_rates(joint);
    joint.control.feedback = Feedback::link;
    joint.control.k_v = 30;
    check_rates(joint);
    joint.control.kind = ControlKind::force;
    joint.control.contact_stiffness = 3e3;
    joint.control.force_gain = 0.3;
    check_rates(joint);
}

TEST_CASE("the Jacobian of a chain is that of finite differences", "[chain]")
{
    const auto [flow, reason] = chain_flow(two_masses(1e6, 50, coulomb(2, 10)));
    REQUIRE(reason == Reason::none);
    const FlowVector scale = flow.scale();
    FlowVector y = flow.steady();
    for (int i = 0; i < flow.size(); ++i) y[i] += 0.1 * (i + 1) * scale[i] / flow.size();
    FlowMatrix J;
    flow.jacobian(y, J);
    for (int k = 0; k < flow.size(); ++k) {
        const double h = 1e-6 * scale[k];
        FlowVector up = y, down = y, above, below;
        up[k] += h, down[k] -= h;
        flow.rate(up, above), flow.rate(down, below);
        for (int i = 0; i < flow.size(); ++i) {
            CAPTURE(i, k);
            CHECK((above[i] - below[i]) / (2 * h) == Approx(J(i, k)).epsilon(1e-6).margin(1e-7 * J.row(i).norm()));
        }
    }
}

TEST_CASE("a stiff spring makes two bodies one", "[chain]")
{
    // 0.5 + 1 kg with Coulomb friction on the motor, which in forward sliding takes a constant force only
    Joint single = example_joint(2e4, 0, 1e-3);
    single.mechanism.inertia = 1.5;
    const auto one = nonlinear_verdict(single, {});
    double last = 1;
    for (const double stiffness : {1e7, 1e8}) {
        const auto two = nonlinear_verdict(two_masses(stiffness, 500, coulomb(2, 0)), {});
        CAPTURE(stiffness);
        CHECK(two.outcome == one.outcome);
        CHECK(two.region == NonlinearRegion::stick_slip);
        const double error = std::abs(two.period / one.period - 1);
        CHECK(error < last / 5);
        last = error;
        CHECK(two.amplitude == Approx(one.amplitude).epsilon(2e5 / stiffness));
    }
}

TEST_CASE("the measured growth rate of several bodies is their spectral abscissa", "[chain]")
{
    for (const double k_p : {5e3, 2e4, 2e5}) {
        const auto joint = two_masses(1e6, 50, coulomb(2, 10));
        auto changed = joint;
        changed.control.k_p = k_p;
        const auto verdict = nonlinear_verdict(changed, {});
        CHECK(verdict.growth_rate == Approx(linear_point(changed).spectral_abscissa).epsilon(1e-5));
    }
}

TEST_CASE("bodies stick by themselves: kinetic and static friction on both ends of a spring", "[chain]")
{
    // the link follows a motor that the loop holds almost rigidly: stick-slip of one mass on the transmission's spring.
    // From rest at F_s it starts with F_s − F_k over F_k: amplitude and period of an undamped block on a spring k
    // pulled at V_0, x = Δ cos + (V_0/ω) sin with Δ = (F_s − F_k)/k: peak speed V_0 + sqrt(V_0² + (ω Δ)²), and
    // sticking lasts 2Δ/V_0.
    Joint joint = two_masses(1e4, 0, coulomb(0, 0));
    joint.control.k_p = 1e9, joint.control.k_v = 2e5;
    KineticStatic law;
    law.kinetic = 5, law.breakaway = 8;
    joint.frictions.link = {};
    joint.frictions.link.law = law;
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::start, 0};
    const auto verdict = nonlinear_verdict(joint, options);
    CHECK(verdict.outcome == Outcome::stick_slip);
    const double omega = 100, delta = 3 / 1e4, V0 = 1e-3;
    CHECK(verdict.velocity_max == Approx(V0 + std::hypot(V0, omega * delta)).epsilon(1e-3));
    const double slip = 2 * (3.14159265358979 - std::atan(omega * delta / V0));
    CHECK(verdict.period == Approx(2 * delta / V0 + slip / omega).epsilon(1e-3));
    CHECK(verdict.stick_fraction == Approx(2 * delta / V0 / verdict.period).epsilon(2e-2));
}

TEST_CASE("a chain's trajectory keeps the link's stick as such", "[chain]")
{
    Joint joint = two_masses(1e6, 50, coulomb(2, 10));
    Stribeck law;
    law.c0 = 5, law.c1 = 10, law.c2 = 3, law.c3 = 1e-2;
    joint.frictions.link = {};
    joint.frictions.link.law = law;
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::start, 0};
    options.duration = 1;
    const auto path = simulate(joint, options);
    CHECK(path.reason == Reason::none);
    int stuck = 0;
    for (std::size_t i = 0; i < path.time.size(); ++i) {
        stuck += path.stuck[i];
        if (path.stuck[i]) CHECK(std::abs(path.friction[i]) <= 8 * (1 + 1e-9));
        if (path.stuck[i]) CHECK(path.velocity[i] == 0);
    }
    CHECK(stuck > 3);
}

TEST_CASE("a lever and the three masses that it stands for end in the same cycle", "[chain]")
{
    // the table of Fig. 4 to Fig. 5: M'_m = N² M_m, M_tr = J/d², k' = N² k, the motor's friction N f(N v)
    constexpr double N = 5, d = 0.1, M_m = 0.001, J = 0.001, k = 2e3, c = 0.1, level = 0.5, viscous = 0.2;
    Joint lever = example_joint(2e4, 1, 1e-3);
    lever.frictions.link = lever.friction;
    lever.frictions.transmission.law = coulomb(0, 0);
    auto& m = lever.mechanism;
    m.link_inertia = 1, m.lever_arm = d;
    m.transmission_link.stiffness = 3e5, m.transmission_link.damping = 10;
    Joint masses = lever;
    m.model = Model::lever;
    m.motor_inertia = M_m, m.transmission_inertia = J;
    m.motor_transmission.stiffness = k, m.motor_transmission.damping = c, m.motor_transmission.ratio = N;
    lever.frictions.motor.law = coulomb(level, viscous);
    auto& three = masses.mechanism;
    three.model = Model::three_mass;
    three.motor_inertia = N * N * M_m, three.transmission_inertia = J / (d * d);
    three.motor_transmission.stiffness = N * N * k, three.motor_transmission.damping = N * N * c;
    masses.frictions.motor.law = coulomb(N * level, N * N * viscous);

    const auto one = nonlinear_verdict(lever, {}), other = nonlinear_verdict(masses, {});
    CHECK(one.growth_rate == Approx(linear_point(lever).spectral_abscissa).epsilon(1e-5));
    CHECK(one.outcome == Outcome::limit_cycle);
    CHECK(other.outcome == Outcome::limit_cycle);
    CHECK(one.period == Approx(other.period).epsilon(1e-6));
    CHECK(one.amplitude == Approx(other.amplitude).epsilon(1e-5));
    CHECK(one.velocity_max == Approx(other.velocity_max).epsilon(1e-5));
}

TEST_CASE("chain: nothing holds a mass under viscous friction alone, and the search beside sliding ends")
{
    Joint joint = two_masses(1e6, 10, coulomb(0, 5));
    joint.control.k_p = 2e5;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.region == NonlinearRegion::stable);
    CHECK(verdict.reason == Reason::none);
}
