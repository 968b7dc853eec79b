// A geared motor's loop counted at its own side, written out, against the same joint counted at the joint's side.
#include "analysis/joint/loop_side.h"
#include "analysis/stability/verdict.h"
#include "tests/oracles/matrices.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>

using namespace stickslip;

namespace {

constexpr double N = 100, J = 2e-5, link = 0.4, stiffness = 9e3, damping = 3, c_motor = 4e-5, c_link = 2;
constexpr double k_p = 0.8, k_v = 0.006, T = 1e-3;

Joint geared()
{
    Joint joint;
    auto& m = joint.mechanism;
    m.motion = Motion::revolute;
    m.model = Model::two_mass;
    m.motor_inertia = J, m.link_inertia = link;
    m.transmission = {.stiffness = stiffness, .damping = damping, .ratio = N};
    joint.control.feedback = Feedback::motor;
    joint.control.k_p = k_p, joint.control.k_v = k_v;
    joint.control.V0 = 0.05;
    joint.control.period = T;
    joint.control.velocity_estimate = {EstimateForm::backward_difference, 0, 1};
    joint.frictions.motor.law = CoulombViscous{0.01, c_motor};
    joint.frictions.link.law = CoulombViscous{1, c_link};
    return joint;
}

/// (θ, ω of the motor, q, v of the link, the reading a tick ago): the torque is the motor's.
struct Loop {
    double torque_per_command = 1, drag = 0, k_p = ::k_p, k_v = ::k_v;
    int reads = 0;  ///< the motor, or 2: the link
};

double largest_multiplier(const Loop& loop)
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(5, 5);
    const auto spring = [&](int row, double share, double inertia) {
        A(row, 0) -= share * stiffness / N / inertia, A(row, 2) += share * stiffness / inertia;
        A(row, 1) -= share * damping / N / inertia, A(row, 3) += share * damping / inertia;
    };
    A(0, 1) = 1, A(2, 3) = 1;
    spring(1, 1 / N, J);
    spring(3, -1, link);
    A(1, 1) -= (c_motor + loop.drag) / J;
    A(3, 3) -= c_link / link;
    A(1, 4) = loop.torque_per_command / J;  // the command is held
    const Eigen::MatrixXd step = test::exponential(A * T);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(5, 5);
    M.topLeftCorner(4, 4) = step.topLeftCorner(4, 4);
    const Eigen::VectorXd push = step.col(4).head(4);
    M.col(loop.reads).head(4) -= push * (loop.k_p + loop.k_v / T);
    M.col(4).head(4) += push * (loop.k_v / T);
    M(4, loop.reads) = 1;
    return test::spectral_radius(M);
}

}  // namespace

TEST_CASE("A loop at the motor's side of a gear has the multipliers of its motor and link", "[loop]")
{
    Joint joint = geared();
    CHECK(reading_per_joint(joint) == N);
    const auto at_joint = linear_verdict(with_loop_at_joint(joint));
    CHECK(std::abs(at_joint.state_variable.multipliers.front()) == Approx(largest_multiplier({})).epsilon(1e-9));

    // volts stay volts: the motor's constants are reflected instead
    joint.actuator.kind = ActuatorKind::dc_motor;
    joint.actuator.signal = DriveSignal::voltage;
    joint.actuator.k_t = 0.03, joint.actuator.k_e = 0.03, joint.actuator.resistance = 0.2;
    const auto volts = linear_verdict(with_loop_at_joint(joint));
    CHECK(std::abs(volts.state_variable.multipliers.front()) ==
          Approx(largest_multiplier({0.03 / 0.2, 0.03 * 0.03 / 0.2})).epsilon(1e-9));

    joint.control.feedback = Feedback::link;
    CHECK(reading_per_joint(joint) == 1);
}

TEST_CASE("A loop that reads the link behind a gear pushes the motor all the same", "[loop]")
{
    Joint joint = geared();
    joint.control.feedback = Feedback::link;
    joint.control.k_p = 8, joint.control.k_v = 0.1;
    const auto at_joint = linear_verdict(with_loop_at_joint(joint));
    CHECK(std::abs(at_joint.state_variable.multipliers.front()) ==
          Approx(largest_multiplier({.k_p = 8, .k_v = 0.1, .reads = 2})).epsilon(1e-9));
}
