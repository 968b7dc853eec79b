// Effects of the friction stage.
#include "tests/blind/generate/effects_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {
namespace {

const std::vector<std::string> all_families = joint_families();
const std::vector<std::string> without_stribeck = {"revolute",   "pendulum", "prismatic", "drive-volts",
                                                   "dc-voltage", "dc-duty",  "two-mass"};

/// + or −, but − only up to what leaves something of the nominal value.
double draw_side(Edit& e, double largest_loss, Draw& draw)
{
    const double side = draw.sign();
    if (side > 0 || largest_loss < 3 * e.smallest) return 1;
    e.largest = std::min(e.largest, largest_loss);
    return -1;
}

Edit coulomb_level(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 1.5};
    const double side = draw_side(e, 0.85, draw), level = n.machine.mechanism.friction[0].coulomb;
    const char* leaf = n.family == "stribeck" ? "c0" : "coulomb";
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed(friction_path(m, leaf), friction(m).coulomb, level * (1 + side * size))};
    };
    return e;
}

Edit viscous(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 3};
    const double unit = n.coulomb() / n.speed, nominal = n.machine.mechanism.friction[0].viscous;
    const double side = draw_side(e, 0.9 * nominal / unit, draw);
    const char* leaf = n.family == "stribeck" ? "c1" : "viscous";
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed(friction_path(m, leaf), friction(m).viscous, nominal + side * size * unit)};
    };
    return e;
}

Edit stribeck(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.05, .largest = 1.5};
    const double velocity = n.speed * draw.log_uniform(0.02, 0.2), exponent = draw.pick({2.0, 2.0, 1.0});
    e.apply = [=, level = n.coulomb()](Machine& m, double size) -> Changed {
        auto& f = friction(m);
        return {changed(friction_path(m, "c2"), f.static_rise, size * level),
                changed(friction_path(m, "c3"), f.stribeck_velocity, velocity),
                changed(friction_path(m, "c4"), f.stribeck_exponent, exponent)};
    };
    return e;
}

Edit asymmetric(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 0.9};
    const double side = draw.sign(), kind = draw.uniform(0, 1);
    const bool with_coulomb = kind > 0.45, with_viscous = kind < 0.85;
    const auto& f = n.machine.mechanism.friction[0];
    e.variant = !with_viscous ? "coulomb" : with_coulomb ? "coulomb-and-viscous" : "viscous";
    // A Coulomb difference alone is, force by force, a constant load.
    if (!with_viscous) e.equivalent = {"constant-load"};
    const double coulomb = with_coulomb ? side * f.coulomb * (with_viscous ? 0.5 : 1) : 0;
    const double slope = with_viscous ? side * f.viscous : 0;
    e.apply = [=](Machine& m, double size) -> Changed {
        Changed list;
        if (coulomb != 0)
            list.push_back(changed(friction_path(m, "asymmetry.coulomb"), friction(m).uneven_coulomb, coulomb * size));
        if (slope != 0)
            list.push_back(changed(friction_path(m, "asymmetry.viscous"), friction(m).uneven_viscous, slope * size));
        return list;
    };
    return e;
}

Edit load_dependent(const Nominal&, double, Draw&)
{
    Edit e{.smallest = 0.01, .largest = 0.5};
    e.apply = [](Machine& m, double size) -> Changed {
        return {changed(friction_path(m, "load_coefficient"), friction(m).load_share, size)};
    };
    return e;
}

Edit presliding(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 1e-4, .largest = 0.03};
    const double damping_ratio = draw.uniform(0.05, 0.5);
    const double level = n.machine.mechanism.friction[0].coulomb, inertia = n.machine.mechanism.inertia[0];
    e.apply = [=, travel = n.travel](Machine& m, double size) -> Changed {
        const double stiffness = level / (size * travel);
        return {changed(friction_path(m, "bristle.stiffness"), friction(m).bristle_stiffness, stiffness),
                changed(friction_path(m, "bristle.damping"), friction(m).bristle_damping,
                        2 * damping_ratio * std::sqrt(stiffness * inertia))};
    };
    return e;
}

Edit memory(const Nominal& n, double, Draw& draw)
{
    const double level = n.machine.mechanism.friction[0].coulomb;
    if (draw.chance(0.25)) {
        Edit e{.variant = "lag", .smallest = 0.05, .largest = 1.2};
        const double velocity = n.speed * draw.log_uniform(0.05, 0.3), lag = draw.log_uniform(8e-3, 60e-3);
        e.apply = [=](Machine& m, double size) -> Changed {
            auto& f = friction(m);
            return {changed(friction_path(m, "curve.c2"), f.static_rise, size * level),
                    changed(friction_path(m, "curve.c3"), f.stribeck_velocity, velocity),
                    changed(friction_path(m, "lag"), f.lag, lag)};
        };
        return e;
    }
    Edit e{.variant = "rate-and-state", .smallest = 0.01, .largest = 0.12};
    const double direct = draw.uniform(0.2, 0.7), length = n.travel * draw.log_uniform(0.005, 0.06);
    const double velocity = n.speed * draw.uniform(0.3, 1);
    e.apply = [=](Machine& m, double size) -> Changed {
        auto& f = friction(m);
        return {changed(friction_path(m, "memory.A"), f.direct, direct * size * level),
                changed(friction_path(m, "memory.B"), f.evolution, size * level),
                changed(friction_path(m, "memory.L"), f.slip_length, length),
                changed(friction_path(m, "memory.V_star"), f.slip_velocity, velocity)};
    };
    return e;
}

Edit position_dependent(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.05, .largest = 0.95};
    const Sine ripple = draw_ripple(n, draw);
    e.apply = [=, level = n.machine.mechanism.friction[0].coulomb](Machine& m, double size) -> Changed {
        auto& r = friction(m).ripple;
        return {changed(friction_path(m, "ripple.amplitude"), r.amplitude, size * level),
                changed(friction_path(m, "ripple.periods"), r.rate, ripple.rate),
                changed(friction_path(m, "ripple.phase"), r.phase, ripple.phase)};
    };
    return e;
}

Edit drift(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.05, .largest = 1.5};
    const double side = draw_side(e, 0.8, draw), time = draw.log_uniform(3, 12);
    e.apply = [=, level = n.machine.mechanism.friction[0].coulomb](Machine& m, double size) -> Changed {
        return {changed(friction_path(m, "drift.change"), friction(m).drift, side * size * level),
                changed(friction_path(m, "drift.time_constant"), friction(m).drift_time, time)};
    };
    return e;
}

}  // namespace

Sine draw_ripple(const Nominal& n, Draw& draw)
{
    double rate = 2 * std::numbers::pi * draw.log_uniform(0.7, 5) / n.travel;
    if (n.machine.revolute) rate = std::max(3.0, std::round(rate));
    return {0, rate, draw.phase()};
}

std::vector<EffectEntry> friction_effects()
{
    return {
        {"coulomb-level", all_families, coulomb_level},
        {"viscous", all_families, viscous},
        {"stribeck", without_stribeck, stribeck},
        {"asymmetric-friction", all_families, asymmetric},
        {"load-dependent-friction", {"revolute", "pendulum", "prismatic", "dc-duty"}, load_dependent},
        {"presliding", without_stribeck, presliding},
        {"frictional-memory", without_stribeck, memory},
        {"position-dependent-friction", all_families, position_dependent},
        {"friction-drift", all_families, drift},
    };
}

}  // namespace blind
