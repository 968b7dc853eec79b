// Questions to the lanes of Stribeck joints, and their answers: plain numbers in dimensionless groups.
#pragma once
#include "analysis/simulation/lanes/job.h"

namespace stickslip::lanes {

/// A single mass under Stribeck friction f(V) = c0 + c1 V + c2 exp(−(V/c3)^n), n = 1 or 2. With T = √(m/k_p),
/// X = x/(V_0 T), u = V/V_0 − 1 and time in T, sliding forwards is
///   X' = u,   u' = −X − ζ u − α (e^{−ρ q(u)} − 1),   q = (1 + u)^n − 1,
/// and at rest X falls at speed 1 until the spring overcomes the static friction.
struct StribeckGroups {
    double zeta;     ///< (k_v + c1) T/m
    double alpha;    ///< c2 e^{−ρ} T/(m V_0)
    double rho;      ///< (V_0/c3)^n
    double reverse;  ///< X beyond which a mass that stops is pushed backwards
    int power;       ///< n
    bool operator==(const StribeckGroups&) const = default;

    /// Where the mass leaves rest: u' = 0 at u = −1.
    double release() const;
    /// ∂u'/∂u of steady sliding, with its sign turned.
    double damping() const;
};

/// One motion to follow; as in Job, what small disturbances do follows from the slow eigenvalue.
struct StribeckJob {
    StribeckGroups groups;
    double rate;       ///< real part of the slow eigenvalue
    double frequency;  ///< its imaginary part, not negative
    bool stated;       ///< `start` is a disturbance of stated size; otherwise a small one, lifted
    double start[2];   ///< X, u; u = −1: at rest, about to leave it
    bool search;       ///< where the disturbance decays, also follow a start from rest
};

struct StribeckAnswer {
    Ending ending = Ending::left_over;
    double u_min = 0, u_max = 0;  ///< of the cycle, like all that follows
    double x_min = 0, x_max = 0;
    double period = 0;
    double rest_time = 0;   ///< with V below a hundredth of V_0
    double multiplier = 0;  ///< Floquet multiplier as the secants see it; 0 of a cycle that sticks
    double peak = missing;  ///< as in Answer
    bool reached = false;
    int turns = 0;
    long steps = 0;
};

void run(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings,
         Instructions instructions);

}  // namespace stickslip::lanes
