// One joint of each kind, with rate-and-state friction on the link and a little viscous friction elsewhere.
#pragma once
#include "analysis/joint/joint.h"
#include "tests/analysis/friction/sample_laws.h"

namespace stickslip::samples {

inline Joint controlled()
{
    Joint joint;
    joint.control.k_p = 2e4;
    joint.control.k_v = 0;
    joint.control.V0 = 1e-3;
    return joint;
}

inline Joint single_mass(double inertia)
{
    Joint joint = controlled();
    joint.mechanism.inertia = inertia;
    joint.friction.law = rate_and_state<RateAndState>();
    return joint;
}

inline Joint two_mass()
{
    Joint joint = controlled();
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = 0.5;
    joint.mechanism.link_inertia = 1;
    joint.mechanism.transmission.stiffness = 1e7;
    joint.mechanism.transmission.damping = 10;
    joint.frictions.motor.law = CoulombViscous{1, 0};
    joint.frictions.link.law = rate_and_state<RateAndState>();
    return joint;
}

inline Joint three_mass()
{
    Joint joint = two_mass();
    joint.mechanism.model = Model::three_mass;
    joint.mechanism.transmission_inertia = 0.2;
    joint.mechanism.motor_transmission = joint.mechanism.transmission_link = joint.mechanism.transmission;
    joint.frictions.transmission.law = CoulombViscous{1, 0};
    return joint;
}

/// One state on each body: nine states.
inline Joint nine_states()
{
    Joint joint = three_mass();
    joint.frictions.motor.law = rate_and_state<RateAndState>({1.2}, {1e-5}, 5);
    joint.frictions.transmission.law = rate_and_state<RateAndState>({1.4}, {2e-5}, 5);
    return joint;
}

}  // namespace stickslip::samples
