// From what has arrived at the actuator to the effort on the mechanism, and what the load adds: the same in records and
// in the simulation of a loop.
#pragma once
#include "analysis/joint/joint.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

/// What the drive does at a velocity v: effort = push − drag · v, within the limit.
struct Push {
    double push = 0, drag = 0;
    double at(double v) const { return push - drag * v; }
};

constexpr double least_resistance =
    0.05;  ///< of a winding that feeds back into a sagging supply, as a share of its own

/// The effort behind dead time and lag. `supply` is the bus voltage of a motor; drive off means an open winding.
inline Push push_of(const Actuator& a, double command, double supply, double v)
{
    Push p;
    if (a.kind == ActuatorKind::dc_motor) {
        const bool bus_known = supply == supply;
        const double duty = a.signal == DriveSignal::duty ? command : bus_known ? command / supply : 0;
        double volts = a.signal == DriveSignal::duty ? command * supply : command;
        if (bus_known) volts = std::clamp(volts, -supply, supply);
        // the supply sags by R_b |i|, also where the motor feeds its current back; there the loop keeps some resistance
        const double sag = std::min(std::abs(duty), 1.0) * a.supply_resistance;
        const bool feeds_back = (volts - a.k_e * v) * duty < 0;
        const double resistance =
            feeds_back ? std::max(a.resistance - sag, least_resistance * a.resistance) : a.resistance + sag;
        p.push = a.effort_gain * a.k_t * volts / resistance;
        p.drag = a.effort_gain * a.k_t * a.k_e / resistance;
    } else {
        p.push = a.effort_gain * command;
        if (a.sag_effort < infinity)
            p.push /= 1 + std::abs(p.push) / a.sag_effort;  // the supply falls with the effort that remains
    }
    if (std::abs(p.at(v)) > a.limit) p = {std::copysign(a.limit, p.at(v)), 0};
    return p;
}

/// Force of the load on the link at this place and time.
inline double load_force(const Load& l, double q, double t)
{
    double force = l.constant;
    if (l.gravity_amplitude != 0) force -= l.gravity_amplitude * std::sin(q + l.gravity_phase);
    if (l.cogging.amplitude != 0) force += l.cogging.amplitude * std::sin(l.cogging.periods * q + l.cogging.phase);
    if (l.disturbance.amplitude != 0)
        force += l.disturbance.amplitude * std::sin(l.disturbance.frequency * t + l.disturbance.phase);
    return force;
}

}  // namespace stickslip
