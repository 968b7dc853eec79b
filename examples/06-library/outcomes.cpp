// What does the joint do after a push, at each of nine position gains? The gains are followed side by side.
#include <stickslip/outcome.h>

#include <cstdio>

#include "threads.h"

int main()
{
    stickslip::RateAndStateRegularised friction;
    friction.f0 = 60;            // N
    friction.A = 1;              // N
    friction.B.push_back(1.5);   // N
    friction.L.push_back(1e-5);  // m
    friction.V_star = 1e-3;      // m/s

    stickslip::Joint joint;
    joint.mechanism.inertia = 1;  // kg
    joint.friction.law = friction;
    joint.control.k_v = 10;   // N·s/m
    joint.control.V0 = 1e-3;  // m/s

    stickslip::NonlinearOptions options;
    options.disturbance = {stickslip::DisturbanceKind::velocity, 2e-4};  // m/s

    std::vector<stickslip::NonlinearVerdict> verdicts(9);
    side_by_side(verdicts.size(), [&](std::size_t i) {
        auto one = joint;
        one.control.k_p = 2e4 + 1e4 * static_cast<double>(i);  // N/m
        verdicts[i] = stickslip::nonlinear_verdict(one, options);
    });
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const auto code = static_cast<std::uint8_t>(verdicts[i].outcome);
        std::printf("k_p = %3zu kN/m  %-15s amplitude %.3g m\n", 20 + 10 * i,
                    std::string(stickslip::code_name("outcome", code)).c_str(), verdicts[i].amplitude);
    }
}
