// Joints that the simulation tests share.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// The one-state slip law in its dimensionless groups: A = L = V_0 = V* = 1, so m = M, k_p = K, k_v = c, B = β.
inline Joint dimensionless_joint(double K, double M, double beta, double c)
{
    Joint joint;
    joint.mechanism.inertia = M;
    joint.control.k_p = K;
    joint.control.k_v = c;
    joint.control.V0 = 1;
    RateAndState law;
    law.f0 = 60;
    law.A = 1;
    law.B.push_back(beta);
    law.L.push_back(1);
    law.V_star = 1;
    joint.friction.law = law;
    return joint;
}

/// The example joint: A = 1, B = 1.5 N, L = 10 µm, f0 = 60 N at V* = 1 mm/s, m = 1 kg.
inline Joint example_joint(double k_p, double k_v, double V0)
{
    Joint joint = dimensionless_joint(k_p, 1, 1.5, k_v);
    joint.control.V0 = V0;
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.L[0] = 1e-5;
    law.V_star = 1e-3;
    return joint;
}

/// The example in a loop whose velocity is a difference of readings; the period is the test's.
inline Joint differencing_joint(double k_p, double k_v)
{
    Joint joint = example_joint(k_p, k_v, 1e-3);
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    return joint;
}

/// The same with k_v = 10 N·s/m at 1 mm/s in a loop of 1 kHz that differences its readings.
inline Joint ticked_joint(double k_p, double delay = 0)
{
    Joint joint = differencing_joint(k_p, 10);
    joint.control.period = 1e-3, joint.control.delay = delay;
    return joint;
}

/// An elbow with a strain wave gear that creeps, its motor's friction under a contact that remembers, an encoder of 19
/// bits behind a reduction of 100 and its noise.
inline Joint creeping_elbow(double k_p, double k_v, double V0)
{
    Joint joint;
    auto& m = joint.mechanism;
    m.motion = Motion::revolute, m.model = Model::two_mass;
    m.motor_inertia = 0.52, m.link_inertia = 1.1;
    m.transmission.stiffness = 31000, m.transmission.damping = 30;
    auto& c = joint.control;
    c.k_p = k_p, c.k_v = k_v, c.V0 = V0, c.period = 1e-3;
    c.velocity_estimate.form = EstimateForm::backward_difference, c.velocity_estimate.tau = 1e-3;
    joint.frictions.motor.law = CoulombViscous{10, 0.2};
    joint.frictions.link.law = CoulombViscous{0.8, 0.5};
    auto& memory = joint.frictions.motor.memory;
    memory.A = 0.1, memory.B = 0.15, memory.L = 4e-6;
    joint.sensor.encoder_quantum = 1.2e-7, joint.sensor.position_noise = 2e-7;
    return joint;
}

/// A joint under the ageing law with the numbers of its slip law.
inline Joint with_ageing(Joint joint)
{
    Ageing law;
    static_cast<RateStateParameters&>(law) = std::get<RateAndState>(joint.friction.law);
    joint.friction.law = law;
    return joint;
}

/// Stribeck friction c0 = 8 N, c1 = 20 N·s/m, c2 = 6 N, c3 = 2 mm/s under 1 kg.
inline Joint stribeck_joint(double k_p, double k_v, double V0)
{
    Joint joint = dimensionless_joint(k_p, 1, 1.5, k_v);
    joint.control.V0 = V0;
    Stribeck law;
    law.c0 = 8, law.c1 = 20, law.c2 = 6, law.c3 = 2e-3;
    joint.friction.law = law;
    return joint;
}

}  // namespace stickslip
