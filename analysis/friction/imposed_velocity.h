// Friction at an interface whose velocity is imposed: the experiments from which state-variable laws were deduced (§2).
#pragma once
#include <functional>
#include <vector>

#include "analysis/friction/friction.h"

namespace stickslip {

/// A stretch of time over which the velocity is a smooth function of the time since its start.
struct VelocityPiece {
    double duration;                         ///< s
    std::function<double(double)> velocity;  ///< V(t), within the law's range
};

/// Samples of one experiment; both sides of a velocity step are kept, at one time and one slip.
struct ImposedMotion {
    std::vector<double> time, slip, velocity, force;
};

/// The friction while the velocity runs through the pieces, from steady sliding at the first velocity on. `samples` a
/// piece, at least 2; between them Runge-Kutta steps that follow the fastest state. Throws std::invalid_argument for a
/// law whose memory is no finite set of states (time lag, kernel with history).
ImposedMotion impose_velocity(const Friction& friction, const std::vector<VelocityPiece>& pieces, int samples);

}  // namespace stickslip
