// What the joint is asked to do in one record: position and velocity of the reference at every time.
#pragma once
#include "tests/blind/generate/machine.h"

#include <string>
#include <vector>

namespace blind {

struct Reference {
    double position = 0, velocity = 0;
};

/// Either a sum of sines that fades in over `fade` seconds, or stretches of constant acceleration.
struct Excitation {
    struct Stretch {
        double begin, position, velocity, acceleration;
    };
    std::string kind;
    double duration = 10, fade = 1;
    std::vector<Sine> sines;
    std::vector<Stretch> stretches;

    Reference at(double t) const;
};

class Draw;

/// "slow-sine", "multi-sine", "steps", "trapezoids", "slow-ramps", "reversals".
const std::vector<std::string>& excitation_kinds();
inline bool is_slow(const std::string& kind)
{
    return kind == "slow-sine" || kind == "slow-ramps";
}

/// Draws a motion of the kind within ±travel, with velocities around `speed`, of 10 to 25 s.
Excitation draw_excitation(const std::string& kind, double travel, double speed, Draw& draw);

}  // namespace blind
