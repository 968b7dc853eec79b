// Where does the joint begin to slide smoothly as the position gain grows? Located by bisection, not read off a grid.
#include <stickslip/boundary.h>
#include <stickslip/parameters.h>

#include <cmath>
#include <cstdio>

#include "threads.h"

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
    joint.control.V0 = 1e-3;  // m/s
    for (const auto& problem : stickslip::check(joint)) {
        std::fprintf(stderr, "%s: %s\n", problem.path.c_str(), problem.message.c_str());
        return 2;
    }

    stickslip::Axis axis;
    axis.path = "control.k_p";
    axis.quantity = stickslip::Quantity::stiffness;
    axis.log = true;
    axis.values = {1e3, 1e6};  // N/m

    stickslip::BoundaryRequest request;
    request.kind = stickslip::BoundaryKind::state_variable;
    request.parallel = side_by_side;
    for (const auto& point : stickslip::locate_boundaries(joint, axis, request).points)
        std::printf("%.9g N/m, within [%.12g, %.12g], stable %s\n", point.value, point.low, point.high,
                    point.direction < 0 ? "above" : "below");
}
