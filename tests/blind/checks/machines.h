// Small machines whose motion is known in closed form.
#pragma once
#include "tests/blind/generate/loop.h"
#include "tests/blind/generate/plant.h"

namespace blind {

inline Machine sliding_mass(double inertia, double coulomb, double viscous = 0)
{
    Machine m;
    m.mechanism.inertia[0] = inertia;
    m.mechanism.friction[0].coulomb = coulomb;
    m.mechanism.friction[0].viscous = viscous;
    return m;
}

inline DriveSignal constant(double level)
{
    return {.level = level};
}

/// A position loop of 25 rad/s round a mass of 0.1, without noise.
inline Machine servo()
{
    Machine m = sliding_mass(0.1, 0.5, 0.2);
    m.controller.k_p = 62.5;
    m.controller.k_v = 4;
    return m;
}

inline Excitation sine(double amplitude, double hertz, double duration)
{
    Excitation e;
    e.duration = duration;
    e.sines = {{amplitude, 6.283185307179586 * hertz, 0}};
    return e;
}

/// A ramp of constant velocity from 0 that starts at once.
inline Excitation ramp(double velocity, double duration)
{
    Excitation e;
    e.duration = duration;
    e.stretches = {{0, 0, velocity, 0}};
    return e;
}

}  // namespace blind
