#include "tests/blind/generate/nominal.h"

#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {
namespace {

constexpr double turn = 2 * std::numbers::pi;

void draw_mechanism(Nominal& n, Draw& draw)
{
    auto& m = n.machine.mechanism;
    n.machine.revolute =
        n.family != "prismatic" && n.family != "drive-volts" && !(n.family == "stribeck" && draw.chance(0.5));
    n.travel = n.machine.revolute ? draw.log_uniform(0.4, 1.6) : draw.log_uniform(0.05, 0.3);
    n.speed = turn * 0.3 * n.travel;
    const double inertia = n.machine.revolute ? draw.log_uniform(0.005, 0.3) : draw.log_uniform(1, 60);
    n.bandwidth = turn * draw.log_uniform(1.8, 7);
    m.inertia[0] = inertia;
    // Coulomb friction holds the joint back from its reference by 0.5 to 4 % of the travel.
    auto& f = m.friction[0];
    f.coulomb = inertia * n.bandwidth * n.bandwidth * n.travel * draw.log_uniform(0.005, 0.04);
    f.viscous = f.coulomb / n.speed * draw.log_uniform(0.05, 0.5);
    if (n.family == "stribeck") {
        f.static_rise = f.coulomb * draw.uniform(0.15, 0.6);
        f.stribeck_velocity = n.speed * draw.log_uniform(0.02, 0.12);
    }
    if (n.family == "pendulum" || n.family == "dc-duty") m.gravity = f.coulomb * draw.log_uniform(1, 6);
    if (n.family == "two-mass") {
        const double share = draw.uniform(0.35, 0.65), resonance = turn * draw.log_uniform(15, 45);
        m.bodies = 2;
        m.inertia[0] = inertia * share;
        m.inertia[1] = inertia * (1 - share);
        const double reduced = inertia * share * (1 - share);
        m.stiffness = reduced * resonance * resonance;
        m.damping = 2 * draw.uniform(0.02, 0.06) * reduced * resonance;
        m.friction[1].coulomb = f.coulomb * 0.2;
        m.friction[1].viscous = f.viscous * 0.2;
        f.coulomb *= 0.8;
        f.viscous *= 0.8;
    }
    if (n.family == "prismatic" && draw.chance(0.3)) m.constant_load = f.coulomb * draw.uniform(-1, 1);
}

/// Chooses the drive and returns how much effort one unit of its signal makes, with the damping by back-EMF.
double draw_drive(Nominal& n, double damping, const std::string& kind, Draw& draw)
{
    auto& d = n.machine.drive;
    const double peak = n.inertia() * n.bandwidth * n.bandwidth * n.travel + n.machine.mechanism.gravity;
    if (kind == "drive-volts") {
        d.gain = peak / draw.uniform(4, 12);
    } else if (kind == "dc-voltage" || kind == "dc-duty") {
        d.kind = kind == "dc-duty" ? Drive::Kind::dc_duty : Drive::Kind::dc_voltage;
        d.supply = draw.pick({12.0, 24.0, 48.0});
        const double stall = peak * draw.uniform(1.2, 2.5);  // effort at full supply and standstill
        // k_t²/R is the damping by back-EMF, k_t V/R the stall effort.
        const double emf_damping = damping * draw.uniform(0.25, 0.6);
        d.torque_constant = d.back_emf = emf_damping * d.supply / stall;
        d.resistance = d.torque_constant * d.supply / stall;
        return d.kind == Drive::Kind::dc_duty ? stall : stall / d.supply;
    }
    return d.gain;
}

double three_digits(double x)
{
    const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
    return std::round(x / unit) * unit;
}

void draw_controller(Nominal& n, const std::string& drive, Draw& draw, Draw& own)
{
    auto& c = n.machine.controller;
    c.period = draw.pick({0.5e-3, 1e-3, 1e-3, 2e-3});
    const double damping = 2 * draw.uniform(0.5, 1.1) * n.inertia() * n.bandwidth;
    double gain = draw_drive(n, damping, drive, n.family == "two-mass" ? own : draw);
    auto& d = n.machine.drive;
    if (d.kind != Drive::Kind::effort && own.chance(0.3)) {
        d.gain = own.uniform(0.6, 0.95);  // what friction of the gear leaves of the motor's effort
        gain *= d.gain;
    }
    const double by_motor = d.gain * d.torque_constant * d.back_emf / d.resistance;
    c.k_p = n.inertia() * n.bandwidth * n.bandwidth / gain;
    c.k_v = std::max(damping - by_motor - n.viscous(), 0.2 * damping) / gain;
    c.filter = draw.chance(0.3) ? 0 : draw.uniform(1e-3, 4e-3);
    c.average = draw.chance(0.2) ? 2 : 1;
    c.reference_velocity = draw.chance(0.7);
    if (d.kind == Drive::Kind::dc_duty) c.limit = 1;
    if (d.kind == Drive::Kind::dc_voltage) c.limit = d.supply;
    if (d.kind == Drive::Kind::effort && draw.chance(0.3)) c.limit = 1.5 * c.k_p * n.travel;
    c.k_p = three_digits(c.k_p);
    c.k_v = three_digits(c.k_v);
}

/// Makes the law integrate: its corner lies at a twentieth to a third of the bandwidth.
void add_integral(Nominal& n, const std::string& structure, Draw& draw)
{
    auto& c = n.machine.controller;
    const double corner = n.bandwidth * draw.uniform(0.05, 0.3);
    if (structure == "pid") {
        c.k_i = three_digits(c.k_p * corner);
        return;
    }
    c.cascade = true;
    c.position_gain = three_digits(c.k_p / c.k_v);
    c.velocity_gain = c.k_v;
    c.velocity_integral = three_digits(c.k_v * corner);
}

void draw_sensors(Nominal& n, Draw& draw)
{
    auto& s = n.machine.sensors;
    s.position_noise = n.travel * draw.log_uniform(2e-5, 1.5e-4);
    if (draw.chance(0.7)) {
        s.quantum = s.position_noise * draw.log_uniform(0.5, 4);
        if (n.machine.revolute) s.quantum = turn / std::exp2(std::round(std::log2(turn / s.quantum)));
    }
    const double effort = n.inertia() * n.bandwidth * n.bandwidth * n.travel;
    s.effort_noise = effort * draw.log_uniform(3e-4, 2e-3);
}

}  // namespace

const std::vector<std::string>& joint_families()
{
    static const std::vector<std::string> families = {"revolute",   "pendulum", "prismatic", "drive-volts",
                                                      "dc-voltage", "dc-duty",  "two-mass",  "stribeck"};
    return families;
}

Nominal draw_nominal(const std::string& family, Draw& draw, const std::string& controller)
{
    Nominal n;
    n.family = family;
    // drawn apart, so that what was added later leaves the other numbers of a seed as they were
    Draw copy = draw, own(seed_of(copy.seed(), 11));
    draw_mechanism(n, draw);
    std::string drive = family;
    if (family == "two-mass") {
        if (own.chance(0.75)) n.machine.reduction = own.log_uniform(1, 160);
        drive = own.pick<std::string>({"effort", "drive-volts", "dc-voltage", "dc-duty"});
    }
    draw_controller(n, drive, draw, own);
    if (controller != "pd") {
        Draw of_law(seed_of(copy.seed(), 12));
        add_integral(n, controller, of_law);
    }
    draw_sensors(n, draw);
    return n;
}

}  // namespace blind
