// Joints of several bodies: independent methods agree, limits are the smaller models.
#include <catch2/catch.hpp>
#include <random>

#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/verdict.h"
#include "analysis/stability/winding.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

constexpr unsigned seed = 20260511;

/// A random joint of one to three bodies with up to two states each, near enough to its boundary to be either.
LinearJoint random_joint(std::mt19937_64& random)
{
    const auto log_uniform = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(random));
    };
    LinearJoint j;
    j.bodies = 1 + static_cast<int>(random() % 3);
    j.measured = random() % 2 == 0 ? 0 : j.link();
    j.actuated[0] = 1;
    for (int i = 0; i < j.bodies; ++i) {
        j.inertia[i] = log_uniform(0.05, 5);
        auto& f = j.friction[i];
        f.f_v = log_uniform(10, 2000);
        f.states = static_cast<int>(random() % 3);
        for (int k = 0; k < f.states; ++k) {
            f.lambda[k] = -log_uniform(10, 1000);
            f.h[k] = 1;
            f.b[k] = f.f_v / f.states * log_uniform(0.5, 2.5) * f.lambda[k];
        }
    }
    for (int i = 0; i + 1 < j.bodies; ++i) {
        j.stiffness[i] = log_uniform(1e4, 1e8);
        j.damping[i] = log_uniform(1, 1000);
    }
    j.k_p = log_uniform(1e2, 1e7);
    j.k_v = random() % 2 == 0 ? 0 : log_uniform(1, 1000);
    return j;
}

}  // namespace

TEST_CASE("Routh's scheme and the spectrum agree for random joints", "[stability]")
{
    std::mt19937_64 random(seed);
    INFO("seed " << seed);
    int stable = 0, total = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto joint = random_joint(random);
        const auto roots = spectrum(joint);
        REQUIRE(static_cast<int>(roots.size()) == joint.states());
        const double abscissa = spectral_abscissa(joint);
        CHECK(abscissa == Approx(roots.front().real()).epsilon(1e-6).margin(1e-6 * std::abs(roots.front())));
        if (std::abs(abscissa) < 1e-7 * std::abs(roots.front())) continue;
        CHECK(is_stable(joint) == (abscissa < 0));
        stable += abscissa < 0;
        ++total;
    }
    CAPTURE(stable, total);
    CHECK(stable > total / 10);
    CHECK(stable < total * 9 / 10);
}

TEST_CASE("polynomial crossings and the search that proves itself agree for random joints", "[stability]")
{
    std::mt19937_64 random(seed + 1);
    INFO("seed " << seed + 1);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const auto joint = random_joint(random);
        const double limit = 1e8;
        std::vector<Crossing> rational;
        for (const auto& c : rational_crossings(joint, Gain::k_p))
            if (c.k_p <= limit) rational.push_back(c);
        const auto proven = search_crossings(joint, limit);
        CAPTURE(i, joint.bodies, joint.measured);
        REQUIRE(proven.doubtful.empty());
        REQUIRE(proven.crossings.size() == rational.size());
        for (std::size_t k = 0; k < rational.size(); ++k) {
            CHECK(proven.crossings[k].k_p == Approx(rational[k].k_p).epsilon(1e-8));
            CHECK(proven.crossings[k].direction == rational[k].direction);
        }
        found += static_cast<int>(rational.size());
    }
    CHECK(found > 150);
}

TEST_CASE("the number of roots right of a line is that of the spectrum", "[stability]")
{
    std::mt19937_64 random(seed + 2);
    INFO("seed " << seed + 2);
    for (int i = 0; i < 300; ++i) {
        const auto joint = random_joint(random);
        for (const double sigma : {0.0, 20.0}) {
            int expected = 0;
            for (const auto& s : spectrum(joint)) expected += s.real() > sigma;
            const auto counted = roots_right_of(joint, sigma);
            REQUIRE(counted);
            CHECK(*counted == expected);
        }
    }
}

TEST_CASE("crossings lie where a pair of eigenvalues is imaginary, in k_p and in k_v", "[stability]")
{
    std::mt19937_64 random(seed + 3);
    INFO("seed " << seed + 3);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const auto joint = random_joint(random);
        for (const Gain gain : {Gain::k_p, Gain::k_v})
            for (const auto& c : rational_crossings(joint, gain)) {
                LinearJoint at = joint;
                (gain == Gain::k_p ? at.k_p : at.k_v) = c.k_p;
                double nearest = infinity;
                for (const auto& s : spectrum(at)) nearest = std::min(nearest, std::abs(s - Complex(0, c.omega)));
                CHECK(nearest < 1e-7 * c.omega);
                ++found;
            }
    }
    CHECK(found > 200);
}

TEST_CASE("a stiff transmission makes several bodies one", "[stability]")
{
    // Fig. 7 with the sum of inertias; friction on the link alone
    auto joint = samples::three_mass();
    joint.mechanism.motor_transmission.stiffness = joint.mechanism.transmission_link.stiffness = 1e12;
    const double whole = linear_verdict(samples::single_mass(0.5 + 0.2 + 1.0)).state_variable.k_cr;
    CHECK(linear_verdict(joint).state_variable.k_cr == Approx(whole).epsilon(1e-5));
    auto two = samples::two_mass();
    two.mechanism.transmission.stiffness = 1e12;
    CHECK(linear_point(two).k_cr == Approx(linear_point(samples::single_mass(1.5)).k_cr).epsilon(1e-5));
    // on the link the same, up to the gain at which the loop excites even this transmission: no single k_cr
    two.control.feedback = Feedback::link;
    const auto link = linear_verdict(two).state_variable;
    REQUIRE(link.stable_intervals.size() == 1);
    CHECK(link.stable_intervals[0].low == Approx(linear_point(samples::single_mass(1.5)).k_cr).epsilon(1e-5));
    CHECK(link.stable_intervals[0].high > 1e6);
    CHECK(link.stable_intervals[0].high < infinity);
    CHECK(std::isnan(link.k_cr));
}

TEST_CASE("a reduction of one is no reduction, and any other is the table of the paper", "[stability]")
{
    auto lever = samples::three_mass();
    lever.mechanism.model = Model::lever;
    lever.mechanism.lever_arm = 0.5;
    lever.mechanism.transmission_inertia = 0.2 * 0.25;  // J_tr = M_tr d²
    const auto straight = spectrum(linear_joint(samples::three_mass(), 1e-3)),
               same = spectrum(linear_joint(lever, 1e-3));
    REQUIRE(straight.size() == same.size());
    for (std::size_t i = 0; i < same.size(); ++i) CHECK(std::abs(same[i] - straight[i]) < 1e-9 * std::abs(same[i]));

    // N = 4: M'_m = 16 M_m, k'_m-tr = 16 k_m-tr, f'_m = 4 f_m(4 ẋ')
    lever.mechanism.motor_transmission.ratio = 4;
    lever.frictions.motor.law = Stribeck{2, 1, 0.5, 1e-2, 2};
    const auto linear = linear_joint(lever, 1e-3);
    CHECK(linear.inertia[0] == Approx(16 * 0.5));
    CHECK(linear.inertia[1] == Approx(0.2));
    CHECK(linear.stiffness[0] == Approx(16 * lever.mechanism.motor_transmission.stiffness));
    const double h = 1e-8, V = 1e-3;
    const auto at_joint = [&](double v) { return 4 * steady_force(lever.frictions.motor, 4 * v); };
    CHECK(steady_slope(linear.friction[0]) == Approx((at_joint(V + h) - at_joint(V - h)) / (2 * h)).epsilon(1e-6));
}

TEST_CASE("force control holds the link by the finger and feeds its force back to the motor", "[stability]")
{
    // one body: every stiffness is (1 + k_f) times the finger and the contact
    Joint joint = samples::single_mass(1);
    const double k_cr = linear_verdict(joint).state_variable.k_cr;
    joint.control.kind = ControlKind::force;
    joint.control.force_gain = 1.5;
    joint.control.contact_stiffness = 3000;
    CHECK(linear_verdict(joint).state_variable.k_cr == Approx(k_cr / 2.5 - 3000).epsilon(1e-10));
    // several bodies, stiff: the same with the sum of inertias
    auto stiff = samples::two_mass();
    stiff.mechanism.transmission.stiffness = 1e13;
    stiff.control.kind = ControlKind::force;
    stiff.control.contact_stiffness = 3000;
    const double heavy = linear_verdict(samples::single_mass(1.5)).state_variable.k_cr;
    CHECK(linear_verdict(stiff).state_variable.k_cr == Approx(heavy - 3000).epsilon(1e-5));
    joint.control.V0 = not_set;
    joint.control.force_rate = 6;
    CHECK(linear_verdict(joint).steady.velocity == Approx(6 / (2e4 + 3000)));
}

TEST_CASE("the velocity-only theory of a joint asks for the k_v at which its own spectrum turns", "[stability]")
{
    auto joint = samples::two_mass();
    joint.frictions.link.law = Stribeck{10, 5, 4, 1e-2, 2};
    const auto verdict = linear_verdict(joint);
    REQUIRE(verdict.velocity_only.k_v_min > 0);
    for (const double factor : {0.99, 1.01}) {
        joint.control.k_v = factor * verdict.velocity_only.k_v_min;
        const auto at = linear_verdict(joint);
        CHECK(at.velocity_only.stable == (factor > 1));
        // no memory in these frictions: both theories are one
        CHECK(at.state_variable.stable == at.velocity_only.stable);
    }
}

TEST_CASE("row and verdict agree", "[stability]")
{
    for (const auto& joint : {samples::single_mass(1), samples::two_mass(), samples::three_mass()}) {
        const auto verdict = linear_verdict(joint);
        const auto point = linear_point(joint);
        CHECK(point.spectral_abscissa == verdict.state_variable.spectral_abscissa);
        CHECK(point.k_v_min == Approx(verdict.velocity_only.k_v_min));
        CHECK(bool(point.state_variable_stable) == verdict.state_variable.stable);
        CHECK(point.k_cr == Approx(verdict.state_variable.k_cr));
    }
}

TEST_CASE("a point without sliding or with numbers out of range has a reason and no verdict", "[stability]")
{
    auto joint = samples::single_mass(1);
    joint.control.V0 = 0;
    const auto at_rest = linear_point(joint);
    CHECK(at_rest.reason != Reason::none);
    CHECK(at_rest.velocity_only_stable == verdict_missing);
    CHECK(at_rest.state_variable_stable == verdict_missing);
    joint.control.V0 = 1e-3;
    joint.mechanism.inertia = 1e-308;
    joint.control.k_v = 1e300;
    const auto beyond = linear_point(joint);
    CHECK(beyond.reason == Reason::not_finite);
    CHECK(beyond.state_variable_stable == verdict_missing);
}

TEST_CASE("a joint that is stable without any velocity gain has a least one", "[stability]")
{
    // the motor's own mass hardly resonates: at k_v → 0 its damping is below rounding, and a crossing is found there
    Joint joint;
    auto& m = joint.mechanism;
    m.motion = Motion::revolute;
    m.model = Model::lever;
    m.motor_inertia = 2.3249525578105274e-06;
    m.link_inertia = 0.4623478239456445;
    m.transmission_inertia = 9.272801729755332e-05;
    m.lever_arm = 0.24322156532462258;
    m.motor_transmission = {.stiffness = 1892.4862034031116, .ratio = 0.012093320826996419};
    m.transmission_link = {.stiffness = 433176.62240385433, .damping = 0.7349398587776951, .ratio = 0.9640616268916673};
    joint.frictions.motor.law = CoulombViscous{1, 0};
    joint.frictions.transmission.law = CoulombViscous{1, 0};
    joint.frictions.link.law = CoulombViscous{1, 75017.37068326058};
    joint.control.k_p = 7078.373426030025;
    joint.control.k_v = 1.991538715545744;
    joint.control.V0 = 0.010118713328095424;
    const auto row = linear_point(joint);
    REQUIRE(row.reason == Reason::none);
    REQUIRE(row.velocity_only_stable);
    CHECK(row.k_v_min < joint.control.k_v);
}
