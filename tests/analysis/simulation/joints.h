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

/// The example of PHYSICS §3-4: A = 1, B = 1.5 N, L = 10 µm, f0 = 60 N at V* = 1 mm/s, m = 1 kg.
inline Joint example_joint(double k_p, double k_v, double V0)
{
    Joint joint = dimensionless_joint(k_p, 1, 1.5, k_v);
    joint.control.V0 = V0;
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.L[0] = 1e-5;
    law.V_star = 1e-3;
    return joint;
}

/// The same joint under the ageing law with the numbers of its slip law.
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
