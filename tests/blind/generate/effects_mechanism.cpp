// Effects of the mechanism and of the world outside it.
#include "tests/blind/generate/effects_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {
namespace {

constexpr double turn = 2 * std::numbers::pi;
const std::vector<std::string> one_mass = {"revolute",   "pendulum", "prismatic", "drive-volts",
                                           "dc-voltage", "dc-duty",  "stribeck"};

Edit inertia(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 1};
    const int body = n.machine.mechanism.bodies - 1;
    const double side = draw.chance(0.6) ? 1 : -1, nominal = n.machine.mechanism.inertia[body];
    if (side < 0) e.largest = 0.5;
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed(body ? "joint.link_inertia" : "joint.inertia", m.mechanism.inertia[body],
                        nominal * (1 + side * size))};
    };
    return e;
}

Edit constant_load(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 2, .equivalent = {"asymmetric-friction"}};
    const double unit = n.coulomb() * draw.sign(), nominal = n.machine.mechanism.constant_load;
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed("load.constant", m.mechanism.constant_load, nominal + size * unit)};
    };
    return e;
}

Edit gravity(const Nominal& n, double, Draw& draw)
{
    const double nominal = n.machine.mechanism.gravity;
    if (nominal > 0 && draw.chance(0.35)) {
        // A tilted base: an encoder that reads too much makes exactly the same motion.
        Edit e{.variant = "phase", .smallest = 0.005, .largest = 0.5, .equivalent = {"sensor-offset"}};
        const double side = draw.sign();
        e.apply = [=](Machine& m, double size) -> Changed {
            return {changed("load.gravity_phase", m.mechanism.gravity_phase, side * size)};
        };
        return e;
    }
    Edit e{.variant = "amplitude", .smallest = 0.02, .largest = nominal > 0 ? 0.8 : 5};
    const double unit = nominal > 0 ? nominal * draw.sign() : n.coulomb();
    e.apply = [=](Machine& m, double size) -> Changed {
        return {changed("load.gravity_amplitude", m.mechanism.gravity, nominal + size * unit)};
    };
    return e;
}

Edit cogging(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 1.2};
    const Sine ripple = draw_ripple(n, draw);
    e.apply = [=, level = n.coulomb()](Machine& m, double size) -> Changed {
        auto& c = m.mechanism.cogging;
        return {changed("load.cogging.amplitude", c.amplitude, size * level),
                changed("load.cogging.periods", c.rate, ripple.rate),
                changed("load.cogging.phase", c.phase, ripple.phase)};
    };
    return e;
}

/// How the only body of a nominal joint falls into a motor and a link.
struct Split {
    double motor_share, link_friction;

    Changed apply(Machine& m, double stiffness, double damping) const
    {
        auto& x = m.mechanism;
        const double inertia = x.inertia[0];
        const auto whole = x.friction[0];
        Changed list = {changed("joint.motor_inertia", x.inertia[0], inertia * motor_share),
                        changed("joint.link_inertia", x.inertia[1], inertia * (1 - motor_share)),
                        changed("joint.transmission.stiffness", x.stiffness, stiffness),
                        changed("joint.transmission.damping", x.damping, damping)};
        x.bodies = 2;
        if (link_friction > 0) {
            x.friction[0].coulomb *= 1 - link_friction;
            x.friction[0].viscous *= 1 - link_friction;
            x.friction[1] = {};
            list.push_back(changed("friction.link.coulomb", x.friction[1].coulomb, link_friction * whole.coulomb));
            list.push_back(changed("friction.link.viscous", x.friction[1].viscous, link_friction * whole.viscous));
        }
        return list;
    }
    double reduced(double inertia) const { return inertia * motor_share * (1 - motor_share); }
};

Edit backlash(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 5e-4, .largest = 0.06};
    if (n.machine.mechanism.bodies == 2) {
        e.apply = [travel = n.travel](Machine& m, double size) -> Changed {
            return {changed("joint.transmission.backlash", m.mechanism.backlash, size * travel)};
        };
        return e;
    }
    const Split split{draw.uniform(0.3, 0.65), draw.uniform(0.1, 0.4)};
    const double contact = turn * draw.log_uniform(50, 120), ratio = draw.uniform(0.1, 0.4);
    e.apply = [=, inertia = n.inertia(), travel = n.travel](Machine& m, double size) -> Changed {
        const double reduced = split.reduced(inertia);
        Changed list = split.apply(m, reduced * contact * contact, 2 * ratio * reduced * contact);
        list.push_back(changed("joint.transmission.backlash", m.mechanism.backlash, size * travel));
        return list;
    };
    return e;
}

Edit compliance(const Nominal& n, double, Draw& draw)
{
    // Size is the period of the free-free resonance, s.
    Edit e{.smallest = 1. / 70, .largest = 1. / 6};
    const Split split{draw.uniform(0.25, 0.7), draw.chance(0.3) ? draw.uniform(0.1, 0.4) : 0};
    const double ratio = draw.log_uniform(0.02, 0.12);
    e.apply = [=, inertia = n.inertia()](Machine& m, double size) -> Changed {
        const double reduced = split.reduced(inertia), omega = turn / size;
        return split.apply(m, reduced * omega * omega, 2 * ratio * reduced * omega);
    };
    return e;
}

Edit periodic(const Nominal& n, double, Draw& draw)
{
    Edit e{.smallest = 0.02, .largest = 1.5};
    const double rate = turn * draw.log_uniform(0.4, 8), phase = draw.phase();
    e.differs_by_record = draw.chance(0.25);
    e.variant = e.differs_by_record ? "phase-of-each-record" : "one-phase";
    e.apply = [=, level = n.coulomb()](Machine& m, double size) -> Changed {
        auto& d = m.mechanism.disturbance;
        return {changed("load.disturbance.amplitude", d.amplitude, size * level),
                changed("load.disturbance.frequency", d.rate, rate), changed("load.disturbance.phase", d.phase, phase)};
    };
    return e;
}

}  // namespace

std::vector<EffectEntry> mechanism_effects()
{
    return {
        {"inertia", joint_families(), inertia},
        {"constant-load", joint_families(), constant_load},
        {"gravity", {"revolute", "pendulum", "pendulum", "dc-duty", "dc-voltage"}, gravity},
        {"cogging", joint_families(), cogging},
        {"backlash", {"revolute", "pendulum", "prismatic", "two-mass"}, backlash},
        {"compliance", one_mass, compliance},
        {"periodic-disturbance", joint_families(), periodic},
    };
}

}  // namespace blind
