// Figs. 1-3 of the paper.
#include "analysis/friction/imposed_velocity.h"
#include "sweep/study/paper/paper_parts.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

/// Over −V … V, without the set-valued point at rest.
Samples steady_curve(const Friction& friction, double highest)
{
    Samples curve;
    constexpr int steps = 400;
    for (const int side : {-1, 1}) {
        if (side > 0) curve.x.push_back(missing), curve.y.push_back(missing);
        for (int i = 0; i <= steps; ++i) {
            const double share = side > 0 ? double(i) / steps : 1 - double(i) / steps;
            const double V = side * std::max(highest * share, 1e-9 * highest);
            curve.x.push_back(V);
            curve.y.push_back(steady_force(friction, V));
        }
    }
    return curve;
}

void add_curves(PaperFriction& f)
{
    Friction kinetic_static, stribeck;
    kinetic_static.law = KineticStatic{10, 14};
    stribeck.law = Stribeck{10, 30, 5, 0.01, 2};
    f.kinetic_static = steady_curve(kinetic_static, 0.1);
    f.stribeck = steady_curve(stribeck, 0.1);
    // where f_{ss}' vanishes: c_{1} = (2 c_{2} V/c_{3}²) e^{−(V/c_{3})²}
    f.end_of_range_A = end_of_falling_friction(stribeck, 0.01, 0.05);
}

void add_velocity_steps(PaperFriction& f)
{
    const double slow = 1e-3, fast = 1e-2, distance = 8e-5;
    const auto at = [](double V, double slip) { return VelocityPiece{slip / V, [V](double) { return V; }}; };
    const auto motion =
        impose_velocity(paper_joint().friction, {at(slow, distance / 2), at(fast, distance), at(slow, distance)}, 400);
    f.velocity_steps = {motion.slip, motion.force};
    f.faster = motion.slip[400], f.slower = motion.slip[800];
}

void add_oscillations(PaperFriction& f)
{
    Friction friction = paper_joint().friction;
    std::get<RateAndState>(friction.law).L[0] = 2e-6;
    const double V0 = 1e-3, V1 = 0.8e-3;  // V_0 > V_1: the velocity keeps its sign
    for (const double omega : {1.0, 100.0, 400.0}) {
        const double period = 2 * std::numbers::pi / omega;
        const VelocityPiece turn{period, [=](double t) { return V0 + V1 * std::sin(omega * t); }};
        const auto motion = impose_velocity(friction, {turn, turn, turn}, 300);
        f.oscillations.push_back(
            {omega,
             {{motion.velocity.end() - 300, motion.velocity.end()}, {motion.force.end() - 300, motion.force.end()}}});
    }
    for (int i = 0; i <= 100; ++i) {
        const double V = V0 - V1 + 2 * V1 * i / 100;
        f.steady.x.push_back(V);
        f.steady.y.push_back(steady_force(friction, V));
    }
}

}  // namespace

PaperFriction paper_friction()
{
    PaperFriction f;
    add_curves(f);
    add_velocity_steps(f);
    add_oscillations(f);
    return f;
}

}  // namespace stickslip
