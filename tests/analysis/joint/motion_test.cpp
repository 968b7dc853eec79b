// Equations of motion: steady sliding is a solution, energy balances, the linear theory is their derivative.
#include <catch2/catch.hpp>

#include "analysis/stability/joint_spectrum.h"
#include "tests/analysis/joint/sample_joints.h"
#include "tests/oracles/motion.h"

using namespace stickslip;

namespace {

std::vector<std::pair<std::string, Joint>> joints()
{
    std::vector<std::pair<std::string, Joint>> list;
    auto geared = samples::nine_states();
    geared.mechanism.motor_transmission.ratio = 3;
    auto lever = geared;
    lever.mechanism.model = Model::lever;
    lever.mechanism.lever_arm = 0.3;
    auto bristled = samples::two_mass();
    bristled.frictions.motor.law = samples::lugre();
    for (auto [name, joint] : {std::pair{"one mass", samples::single_mass(1)},
                               {"two", samples::two_mass()},
                               {"two, lugre on the motor", bristled},
                               {"three, geared", geared},
                               {"lever", lever}}) {
        joint.control.k_v = 7;
        joint.load.constant = -4;
        list.emplace_back(name, joint);
        joint.control.feedback = Feedback::link;
        list.emplace_back(std::string(name) + ", link feedback", joint);
        joint.control.kind = ControlKind::force;
        joint.control.contact_stiffness = 500;
        joint.control.force_gain = 0.7;
        list.emplace_back(std::string(name) + ", force", joint);
    }
    return list;
}

}  // namespace

TEST_CASE("steady sliding solves the equations of motion of every joint", "[joint]")
{
    for (const auto& [name, joint] : joints()) {
        CAPTURE(name);
        const JointMotion motion(joint);
        const double t = 3.7, h = 1e-2;
        const auto y = motion.steady(t), later = motion.steady(t + h);
        std::vector<double> rate(y.size());
        motion.rate(t, y.data(), rate.data());
        for (int i = 0; i < motion.size(); ++i) {
            CAPTURE(i);
            const double acceleration_scale = i >= motion.bodies() ? 1e-6 : 1e-10;
            CHECK(rate[i] == Approx((later[i] - y[i]) / h).epsilon(1e-9).margin(acceleration_scale));
        }
        CHECK(y[2 * motion.bodies() - 1] == motion.commanded_velocity());
    }
}

TEST_CASE("energy changes by what comes in less what friction takes", "[joint]")
{
    for (const auto& [name, joint] : joints()) {
        CAPTURE(name);
        const JointMotion motion(joint);
        auto y = motion.steady(0);
        for (int i = 0; i < motion.bodies(); ++i) {
            y[i] += 1e-6 * (i + 1);
            y[motion.bodies() + i] *= 1.3 + 0.2 * i;
        }
        std::vector<double> rate(y.size());
        motion.rate(0, y.data(), rate.data());
        // dE/dt along the motion by differences
        const double h = 1e-7;
        auto ahead = y, behind = y;
        for (std::size_t i = 0; i < y.size(); ++i) {
            ahead[i] += h * rate[i];
            behind[i] -= h * rate[i];
        }
        const double change = (motion.energy(ahead.data()) - motion.energy(behind.data())) / (2 * h);
        const double balance = motion.input(0, y.data()) - motion.dissipation(y.data());
        CHECK(change == Approx(balance).epsilon(1e-6).margin(1e-6 * motion.dissipation(y.data())));
    }
}

TEST_CASE("the analytic linearisation is the derivative of the equations of motion", "[joint]")
{
    for (const auto& [name, joint] : joints()) {
        CAPTURE(name);
        const JointMotion motion(joint);
        const auto A = state_matrix(linear_joint(joint, motion.commanded_velocity()));
        REQUIRE(A.rows() == motion.size());
        const auto y = motion.steady(0);
        for (int k = 0; k < motion.size(); ++k) {
            const bool velocity = k >= motion.bodies() && k < 2 * motion.bodies();
            const double h = velocity ? 1e-5 * std::abs(y[k]) : 1e-6 * std::max(std::abs(y[k]), 1e-3);
            auto ahead = y, behind = y;
            ahead[k] += h;
            behind[k] -= h;
            std::vector<double> up(y.size()), down(y.size());
            motion.rate(0, ahead.data(), up.data());
            motion.rate(0, behind.data(), down.data());
            for (int i = 0; i < motion.size(); ++i) {
                CAPTURE(i, k);
                const double difference = (up[i] - down[i]) / (2 * h);
                const double noise = 1e-13 * (std::abs(up[i]) + 1e3) / h;
                CHECK(A(i, k) == Approx(difference).epsilon(1e-5).margin(noise));
            }
        }
    }
}
