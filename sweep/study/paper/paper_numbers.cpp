#include "sweep/study/paper/paper_numbers.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/friction/imposed_velocity.h"
#include "analysis/numerics/maximum.h"
#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/steady.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double A = 1, B = 1.5, L = 1e-5, V0 = 1e-3;  // of paper_joint()

double located(const Joint& joint)
{
    return locate_on_ray(joint, "control.k_p", 1e3, 1e7, true, Curve::Kind::state_variable).at(0).value;
}

/// Im s of the rightmost root.
double frequency(const Joint& joint)
{
    return std::abs(linear_verdict(joint).state_variable.eigenvalues.at(0).imag());
}

/// (35) in closed form for one state.
double k_cr(double m, double k_v, double V)
{
    return (B - A - k_v * V) / L * (1 + m * V / (L * (k_v + A / V)));
}

void add_friction(std::vector<PaperNumber>& list)
{
    const Friction friction = paper_joint().friction;
    const double fast = 1e-2;
    const auto motion = impose_velocity(
        friction, {{0.1, [](double) { return V0; }}, {40 * L / fast, [=](double) { return fast; }}}, 400);
    const double before = motion.force[399], after = motion.force[400], end = motion.force.back();
    list.push_back(
        {"(6)", "f_{ss} at 10 V_{0}: f_{0} + (A − B) ln 10", 60 + (A - B) * std::log(10), end, Quantity::effort});
    list.push_back({"§2 (2)", "jump of friction when velocity rises tenfold: A ln 10", A * std::log(10), after - before,
                    Quantity::effort});
    // between the 1st and the 11th sample of 400 over 40 L the excess falls by e for each L
    const double slip = motion.slip[410] - motion.slip[400];
    list.push_back({"§2 (3)", "slip over which friction decays by e: L", L,
                    slip / std::log((after - end) / (motion.force[410] - end)), Quantity::position});
}

void add_velocity_only(std::vector<PaperNumber>& list)
{
    Joint joint = paper_joint();
    list.push_back({"(21)", "least k_{v} of the velocity-only model: (B − A)/V_{0}", (B - A) / V0,
                    compare_theories(joint).k_v_demanded_velocity_only(), Quantity::damping});
    const double c1 = 30, c2 = 5, c3 = 0.01;
    joint.friction = {};
    joint.friction.law = Stribeck{10, c1, c2, c3, 2};
    const auto hardest = velocity_gain_for_range(joint, 1);
    list.push_back({"(25)", "hardest velocity: c_{3}/√2", c3 / std::sqrt(2), hardest.velocity, Quantity::velocity});
    list.push_back({"(26)", "k_{v} for every velocity: √2 c_{2}/c_{3} e^{−1/2} − c_{1}",
                    std::sqrt(2) * c2 / c3 * std::exp(-0.5) - c1, hardest.k_v, Quantity::damping});
}

void add_memory(std::vector<PaperNumber>& list)
{
    Joint joint = paper_joint();
    joint.control.k_p = 1e13;
    joint.control.k_v = 200;
    // not the slow root of the memory: the pair that runs off to infinity
    double real = missing, highest = 0;
    for (const auto& s : linear_verdict(joint).state_variable.eigenvalues)
        if (s.imag() > highest) highest = s.imag(), real = s.real();
    list.push_back({"(28)", "Re s as k_{p} → ∞: −(f_{v} + k_{v})/(2m)", -(A / V0 + 200) / 2, real, Quantity::rate});
    joint = paper_joint();
    list.push_back({"(8)", "steady deflection: f_{ss}/k_{p}", 60 / joint.control.k_p, steady_sliding(joint).deflection,
                    Quantity::position});
    joint.control.k_p = located(joint);
    list.push_back({"(34)", "frequency at the critical gain", std::sqrt((V0 / L) * (V0 / L) * (B - A) / A),
                    frequency(joint), Quantity::angular_frequency});
    list.push_back({"(35)", "k_{cr} at m = 1 kg, k_{v} = 0", k_cr(1, 0, V0), joint.control.k_p, Quantity::stiffness});
    joint.mechanism.inertia = 2;
    joint.control.k_v = 100;
    list.push_back(
        {"(35)", "k_{cr} at m = 2 kg, k_{v} = 100 N·s/m", k_cr(2, 100, V0), located(joint), Quantity::stiffness});
    joint = paper_joint();
    joint.control.V0 = 1e-2;
    list.push_back({"(35)", "k_{cr} at V_{0} = 10 mm/s", k_cr(1, 0, 1e-2), located(joint), Quantity::stiffness});
    joint = paper_joint();
    joint.control.kind = ControlKind::force;
    list.push_back({"(10)", "k_{cr} under force control: that of position control", k_cr(1, 0, V0), located(joint),
                    Quantity::stiffness});
    joint = paper_joint();
    joint.control.k_p = 1e-4;
    list.push_back({"(37)", "k_{v} that makes every k_{p} stable: ∫g − f_{v}", (B - A) / V0,
                    compare_theories(joint).k_v_demanded_memory(), Quantity::damping});
}

void add_others(std::vector<PaperNumber>& list)
{
    // Gu, Rice, Ruina & Tse (1984), [5]: dimensionless, no inertia, here a negligible one
    Joint joint = paper_joint();
    joint.mechanism.inertia = 1e-9;
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.f0 = 0, law.A = 1, law.V_star = 1;
    law.B = {}, law.L = {};
    for (const double b : {1.0, 0.84}) law.B.push_back(b);
    for (const double l : {1.0, 1 / 0.048}) law.L.push_back(l);
    joint.control.V0 = 1;
    joint.control.k_p = 0.1;
    list.push_back({"[5]", "κ_{cr} of two states, without inertia", 0.0802755656,
                    linear_verdict(joint).state_variable.k_cr, Quantity::number});
    // §2, [6]: m = 1 kg, slope −100 N·s/m behind 5 ms; (34) holds at ωτ = π/2, where sin ωτ = 1
    LinearJoint late;
    late.inertia[0] = late.actuated[0] = 1;
    late.k_p = 1e5;
    late.friction[0].delays.push_back({100, 5e-3});
    const double omega = std::numbers::pi / 2 / 5e-3;
    list.push_back({"§2 [6]", "lower end of the first window of k_{p} under a time lag of 5 ms",
                    omega * omega + 100 * omega, crossings(late).crossings.at(0).k_p, Quantity::stiffness});
}

}  // namespace

Joint paper_joint()
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = 2e4;
    joint.control.V0 = 1e-3;
    RateAndState law;
    law.f0 = 60, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5);
    law.L.push_back(1e-5);
    joint.friction.law = law;
    return joint;
}

std::vector<PaperNumber> paper_numbers()
{
    std::vector<PaperNumber> list;
    add_friction(list);
    add_velocity_only(list);
    add_memory(list);
    add_others(list);
    return list;
}

double end_of_falling_friction(const Friction& friction, double slow, double fast)
{
    return maximiser([&](double V) { return -steady_force(friction, V); }, slow, fast);
}

}  // namespace stickslip
