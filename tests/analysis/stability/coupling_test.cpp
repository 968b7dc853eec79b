// A normal load that moves and neighbours: known critical gains, the polynomials written out, limits.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/neighbour_modes.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/oracles/matrices.h"

using namespace stickslip;

namespace {

Joint reference(double k_v = 10)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = 60000;
    joint.control.k_v = k_v;
    joint.control.V0 = 1e-3;
    RateAndState law;
    law.f0 = 60, law.A = 1, law.L = {}, law.V_star = 1e-3;
    law.B = {}, law.B.push_back(1.5);
    law.L.push_back(1e-5);
    joint.friction.law = law;
    joint.normal.mu = 0.6;
    joint.normal.alpha = 0.2;
    return joint;
}

/// The rightmost root of c_0 + c_1 s + … by its companion matrix.
double rightmost(const std::vector<double>& c)
{
    const int n = static_cast<int>(c.size()) - 1;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i + 1 < n; ++i) A(i, i + 1) = 1;
    for (int i = 0; i < n; ++i) A(n - 1, i) = -c[i] / c[n];
    return test::spectral_abscissa(A);
}

}  // namespace

TEST_CASE("critical gains under a normal load that moves", "[stability][coupling]")
{
    struct Row {
        double n0, n1, n2, k_cr;
    };
    for (const Row row : {Row{1e4, 0, 0, 50049.504950495}, Row{-1e4, 0, 0, 57653.465346535},
                          Row{0, 10, 0, 53173.175542406}, Row{0, 0, 0.1, 54035.573122530}}) {
        auto joint = reference();
        joint.normal.displacement = row.n0, joint.normal.velocity = row.n1, joint.normal.acceleration = row.n2;
        const auto verdict = linear_verdict(joint);
        CHECK(verdict.state_variable.k_cr == Approx(row.k_cr).epsilon(1e-9));
        // the cubic of the theory, written out
        const double mu = 0.6, alpha = 0.2, lambda = 100, C = 10 + 1 / 1e-3, k_p = joint.control.k_p;
        const double cubic = rightmost(
            {(k_p + mu * row.n0) * lambda, (C + mu * row.n1) * lambda + k_p + (mu - alpha) * row.n0 - 1.5 / 1e-5,
             (1 + mu * row.n2) * lambda + C + (mu - alpha) * row.n1, 1 + (mu - alpha) * row.n2});
        CHECK(verdict.state_variable.spectral_abscissa == Approx(cubic).epsilon(1e-9));
    }
}

TEST_CASE("a normal load beside friction of the transmitted effort: the loop keeps its share of the gains",
          "[stability][coupling]")
{
    auto joint = reference();
    joint.normal.displacement = 1e4, joint.normal.velocity = 5, joint.normal.acceleration = 0.1;
    auto lossless = joint;
    joint.friction.load_coefficient = 0.25;
    lossless.control.k_p *= 0.75, lossless.control.k_v *= 0.75;
    CHECK(growth_rate(joint) == Approx(growth_rate(lossless)).epsilon(1e-9));
    CHECK(velocity_only_growth_rate(joint) == Approx(velocity_only_growth_rate(lossless)).epsilon(1e-9));
}

TEST_CASE("the velocity-only theory knows of the load and not of the state", "[stability][coupling]")
{
    auto joint = reference();
    joint.normal.displacement = 1e4, joint.normal.velocity = 5, joint.normal.acceleration = 0.1;
    const auto curve = velocity_only(linear_joint(joint, 1e-3));
    CHECK(curve.inertia[0] == Approx(1 + 0.6 * 0.1));
    CHECK(steady_slope(curve.friction[0]) == Approx((1 - 1.5) / 1e-3 + 0.6 * 5));
}

TEST_CASE("critical gains beside a neighbour", "[stability][coupling]")
{
    struct Row {
        double k_p, k_v, k_cr, precision;
    };
    for (const Row row : {Row{1e4, 100, 53774.76, 1e-6}, Row{3e3, 10, 53016.11, 1e-6}, Row{2e3, 5, 46684, 2e-5},
                          Row{1e12, 1e3, 53851.485149, 1e-6}, Row{1e-4, 1e-2, 52978.218, 1e-5}}) {
        auto joint = reference();
        joint.neighbour.push_back({0.5, 0.3, row.k_p, row.k_v});
        const auto verdict = linear_verdict(joint);
        INFO("k_pk " << row.k_p);
        const auto& stable = verdict.state_variable.stable_intervals;
        REQUIRE(!stable.empty());
        CHECK(stable.back().low == Approx(row.k_cr).epsilon(row.precision));
        // mass, damping and stiffness matrices of both joints, and the state of the friction
        const double k_p = joint.control.k_p, A = 1e3, B = 1.5e3, lambda = 100;
        Eigen::Matrix2d M;
        M << 1, 0.3, 0.3, 0.5;
        Eigen::MatrixXd S = Eigen::MatrixXd::Zero(5, 5), F = Eigen::MatrixXd::Zero(2, 5);
        F << -k_p, 0, -(10 + A), 0, -1, 0, -row.k_p, 0, -row.k_v, 0;
        S(0, 2) = S(1, 3) = 1;
        S.block(2, 0, 2, 5) = M.inverse() * F;
        S(4, 2) = -lambda * B, S(4, 4) = -lambda;
        const double abscissa = test::spectral_abscissa(S);
        if (row.k_p > 0 && row.k_p < 1e6)
            CHECK(verdict.state_variable.spectral_abscissa == Approx(abscissa).epsilon(1e-8).margin(1e-8));
    }
}

TEST_CASE("a neighbour's mode near the frequency of friction is warned of", "[stability][coupling]")
{
    auto joint = reference();
    joint.neighbour.push_back({0.5, 0.3, 2e3, 5});     // √4000 = 63 rad/s beside 70
    joint.neighbour.push_back({0.5, 0.05, 2e5, 500});  // 632 rad/s
    const auto near = near_modes(joint);
    REQUIRE(near.size() == 1);
    CHECK(near[0].neighbour == 0);
    CHECK(near[0].omega == Approx(std::sqrt(4000.0)));
}

TEST_CASE("a drive's gain beside a neighbour is the same loop as its product with the controller's gains",
          "[stability][coupling]")
{
    auto ideal = reference();
    ideal.neighbour.push_back({0.5, 0.3, 2e3, 5});
    auto driven = ideal;
    driven.actuator.effort_gain = 2;
    driven.control.k_p /= 2, driven.control.k_v /= 2;
    CHECK(linear_verdict(driven).state_variable.spectral_abscissa ==
          Approx(linear_verdict(ideal).state_variable.spectral_abscissa).epsilon(1e-6));
}

TEST_CASE("A load that lifts off as the link moves takes a root through 0 at the gain that just holds it",
          "[stability]")
{
    // Z(0) = k_p + k_c + mu n_0: below k_p = 0.6 * 1742.9 - 271.3 = 774.44 N/m nothing holds the link
    Joint joint = example_joint(6700, 250, 1e-3);
    std::get<RateAndState>(joint.friction.law).B[0] = 1.01;
    joint.control.contact_stiffness = 271.3;
    joint.normal.displacement = -1742.9, joint.normal.mu = 0.6;
    for (const double delay : {0.0, 1e-3}) {
        CAPTURE(delay);
        if (delay > 0) {
            Kernel kernel;
            kernel.f0 = 60, kernel.f_v = 1000, kernel.V_star = 1e-3;
            kernel.impulses.push_back({10, delay});
            joint.friction.law = kernel;
        }
        const auto memory = linear_verdict(joint).state_variable;
        REQUIRE(memory.stable_intervals.size() == 1);
        CHECK(memory.stable_intervals[0].low == Approx(774.44).epsilon(1e-9));
        REQUIRE_FALSE(memory.crossings.empty());
        CHECK(memory.crossings[0].omega == 0);
        CHECK(memory.crossings[0].direction == -1);
        for (const double k_p : {770.0, 780.0}) {
            Joint at = joint;
            at.control.k_p = k_p;
            CHECK((growth_rate(at) < 0) == (k_p > 774.44));
        }
    }
}
