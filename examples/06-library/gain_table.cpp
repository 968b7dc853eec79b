// Which position gain does a joint need at each velocity, and what would velocity feedback alone need?
#include <stickslip/verdict.h>

#include <cstdio>

int main()
{
    stickslip::RateAndState friction;
    friction.f0 = 60;            // N
    friction.A = 1;              // N
    friction.B.push_back(1.5);   // N
    friction.L.push_back(1e-5);  // m
    friction.V_star = 1e-3;      // m/s

    stickslip::Joint joint;
    joint.mechanism.inertia = 1;  // kg
    joint.friction.law = friction;
    joint.control.k_p = 6e4;  // N/m
    joint.control.k_v = 10;   // N·s/m

    std::puts("V_0 [m/s]   k_cr [N/m]   velocity-only: k_v > [N·s/m]");
    for (double velocity : {1e-4, 1e-3, 1e-2}) {
        joint.control.V0 = velocity;
        auto verdict = stickslip::linear_verdict(joint);
        std::printf("%-11.0e %-12.6g %.6g\n", velocity, verdict.state_variable.k_cr, verdict.velocity_only.k_v_min);
    }
}
