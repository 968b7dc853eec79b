// Random joints of two masses whose friction is smooth.
#pragma once
#include "tests/analysis/simulation/lanes/watched_joints.h"

namespace stickslip {

enum class Remembers { on_link, on_motor, on_both };

/// Two masses, friction with memory on one of them and viscous friction on the other, or memory on both with slip
/// distances up to a decade apart; a gear from 1 to 100, a transmission up to 100 times as stiff as the loop, which
/// measures the link in one of four; gains of a decade about the critical gain of one mass under that law.
inline std::vector<Joint> random_two_mass_joints(std::size_t count, unsigned seed, Remembers memory)
{
    Uniform uniform(seed);
    std::vector<Joint> joints;
    while (joints.size() < count) {
        const double V0 = std::pow(10, uniform(-5, -2)), L = std::pow(10, uniform(-6, -4)),
                     A = std::pow(10, uniform(-1, 1)), m = std::pow(10, uniform(-1, 1)), beta = uniform(1.05, 3),
                     c = uniform(0, 1.2) * (beta - 1), M = m * V0 * V0 / (L * A);
        const double K_cr = c < beta - 1 ? (beta - 1 - c) * (1 + M / (1 + c)) : beta - 1;
        const double K = K_cr * std::pow(10, uniform(-1, 0.5));
        const double N = std::pow(10, uniform(0, 2)), on_motor = uniform(0.1, 0.9);
        Joint joint = example_joint(K * A / L, c * A / V0, V0);
        joint.control.feedback = uniform(0, 1) < 0.25 ? Feedback::link : Feedback::motor;
        auto& mechanism = joint.mechanism;
        mechanism.model = Model::two_mass;
        mechanism.motor_inertia = on_motor * m / (N * N), mechanism.link_inertia = (1 - on_motor) * m;
        auto& gear = mechanism.transmission;
        gear.ratio = N, gear.stiffness = joint.control.k_p * std::pow(10, uniform(0, 2));
        gear.damping = uniform(0, 0.2) * std::sqrt(gear.stiffness * m);
        auto law = std::get<RateAndState>(joint.friction.law);
        const double share = memory == Remembers::on_both ? uniform(0.2, 0.8) : 1, other = std::pow(10, uniform(0, 1));
        law.A = share * A, law.B[0] = share * beta * A, law.L[0] = L;
        auto &link = joint.frictions.link.law, &motor = joint.frictions.motor.law;
        link = law;
        law.A = A / N * (share < 1 ? 1 - share : 1), law.B[0] = beta * law.A;
        law.L[0] = N * L * (share < 1 ? other : 1);
        motor = law;
        const double viscous = uniform(0, 0.3) * A / V0;
        if (memory == Remembers::on_motor) link = CoulombViscous{0, viscous};
        if (memory == Remembers::on_link) motor = CoulombViscous{0, viscous / (N * N)};
        joints.push_back(joint);
    }
    return joints;
}

/// The same joint under the ageing law.
inline Joint with_ageing_masses(Joint joint)
{
    for (Friction* friction : {&joint.frictions.link, &joint.frictions.motor}) {
        const auto* slip = std::get_if<RateAndState>(&friction->law);
        if (slip) friction->law = Ageing{*slip};
    }
    return joint;
}

}  // namespace stickslip
