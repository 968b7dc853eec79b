// From what has arrived at the actuator to the effort on the mechanism, and what the load adds: the same in records and
// in the simulation of a loop, for one joint and for packs of them (simulation/lanes/pack.h).
#pragma once
#include "analysis/base/select.h"
#include "analysis/joint/joint.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

/// What the drive does at a velocity v: effort = push − drag · v, within the limit.
template <class Real>
struct PushOf {
    Real push = 0, drag = 0;
    Real at(const Real& v) const { return push - drag * v; }
};
using Push = PushOf<double>;

constexpr double least_resistance =
    0.05;  ///< of a winding that feeds back into a sagging supply, as a share of its own

/// What a command makes of a drive as long as it is held, behind dead time and lag: the velocity decides only whether
/// the motor feeds its current back, and whether the effort is within its limit.
template <class Real>
struct HeldDrive {
    PushOf<Real> driven, feeding;  ///< without the limit; `feeding` of motors only
    Real volts = 0, duty = 0, k_e = 0, limit = infinity;
    bool motor = false;

    PushOf<Real> at(const Real& v) const
    {
        using std::abs, std::copysign;
        PushOf<Real> p = driven;
        if (motor) {
            const auto feeds_back = (volts - k_e * v) * duty < Real(0.0);
            p.push = select(feeds_back, feeding.push, driven.push);
            p.drag = select(feeds_back, feeding.drag, driven.drag);
        }
        const Real effort = p.at(v);
        const auto beyond = limit < abs(effort);
        p.push = select(beyond, copysign(limit, effort), p.push);
        p.drag = select(beyond, Real(0.0), p.drag);
        return p;
    }
};

/// `supply` is the bus voltage of a motor; drive off means an open winding.
template <class Drive, class Real>
HeldDrive<Real> held_drive(const Drive& a, const Real& command, const Real& supply)
{
    using std::abs, std::max, std::min;
    HeldDrive<Real> d;
    d.limit = Real(a.limit);
    d.motor = a.kind == ActuatorKind::dc_motor;
    if (d.motor) {
        const auto bus_known = supply <= supply;
        const bool by_duty = a.signal == DriveSignal::duty;
        d.duty = by_duty ? command : select(bus_known, command / supply, Real(0.0));
        d.volts = by_duty ? command * supply : command;
        d.volts = select(bus_known, min(max(d.volts, -supply), supply), d.volts);
        d.k_e = Real(a.k_e);
        // the supply sags by R_b |i|, also where the motor feeds its current back; there the loop keeps some resistance
        const Real sag = min(abs(d.duty), Real(1.0)) * a.supply_resistance;
        const Real driven = a.resistance + sag, feeding = max(a.resistance - sag, least_resistance * a.resistance);
        const Real force = a.effort_gain * a.k_t * d.volts, damping = a.effort_gain * a.k_t * a.k_e;
        d.driven = {force / driven, damping / driven};
        d.feeding = {force / feeding, damping / feeding};
    } else {
        d.driven.push = a.effort_gain * command;
        const auto sags = Real(a.sag_effort) < Real(infinity);
        if (any(sags))  // the supply falls with the effort that remains
            d.driven.push = select(sags, d.driven.push / (1.0 + abs(d.driven.push) / a.sag_effort), d.driven.push);
    }
    return d;
}

/// The effort behind dead time and lag.
template <class Drive, class Real>
PushOf<Real> push_of(const Drive& a, const Real& command, const Real& supply, const Real& v)
{
    return held_drive<Drive, Real>(a, command, supply).at(v);
}
inline Push push_of(const Actuator& a, double command, double supply, double v)
{
    return push_of<Actuator, double>(a, command, supply, v);
}

/// Force of the load on the link at this place and time.
template <class Outside, class Real>
Real load_force(const Outside& l, const Real& q, const Real& t)
{
    const Real none(0.0);
    Real force = l.constant;
    if (any(Real(l.gravity_amplitude) != none)) force = force - l.gravity_amplitude * sine(q + l.gravity_phase);
    const auto& c = l.cogging;
    if (any(Real(c.amplitude) != none) || any(Real(c.second_amplitude) != none)) force = force + wave_at(c, q);
    if (any(Real(l.disturbance.amplitude) != none))
        force = force + l.disturbance.amplitude * sine(l.disturbance.frequency * t + l.disturbance.phase);
    return force;
}

}  // namespace stickslip
