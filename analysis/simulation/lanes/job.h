// What the lanes are asked and what they answer: plain numbers in the four dimensionless groups.
#pragma once
#include <cstddef>
#include <cstdint>

#include "analysis/results/point.h"

namespace stickslip::lanes {

/// The one-state slip law on a single mass depends on four numbers only. With X = x/L, w = ln(V/V_0),
/// p = (θ − θ_ss)/A and time in L/V_0:
///   X' = e^w − 1,   M e^w w' = −(c (e^w − 1) + K X + w + p),   p' = −e^w (p + β w)
struct Groups {
    double K;     ///< k_p L/A
    double M;     ///< m V_0²/(L A)
    double beta;  ///< B/A
    double c;     ///< k_v V_0/A
    bool operator==(const Groups&) const = default;
};

/// Size of the disturbance whose growth is measured. The lanes count from steady sliding, so that nothing is lost to
/// rounding, and can afford one whose quadratic terms do not show.
inline constexpr double probe = 1e-9;

/// One motion to follow.
struct Job {
    Groups groups;
    double start[3];       ///< X, w, p: small where `window` is set
    double left[3][2];     ///< left eigenvector of the slow mode, real and imaginary parts
    double window;         ///< time over which the growth of the small disturbance is measured
    double fineness;       ///< share of rtol that holds in that time
    double rate;           ///< real part of the slow eigenvalue, decides where the measured growth is too small
    double magnitude;      ///< |s| of the slow eigenvalue
    bool search;           ///< where small disturbances decay, also follow a start from near rest
    double rest_start[3];  ///< that start
};

enum class Ending : std::uint8_t {
    decays,    ///< back to steady sliding; the search, if asked for, found no cycle
    cycle,     ///< small disturbances grow into this cycle
    bistable,  ///< small disturbances decay, the start from near rest ends in this cycle
    left_over  ///< not for the lanes: the reference must decide
};

struct Answer {
    Ending ending = Ending::left_over;
    double growth = missing;      ///< per unit of time
    double w_min = 0, w_max = 0;  ///< of the cycle, like all that follows
    double x_min = 0, x_max = 0;
    double period = 0;
    double rest_time = 0;   ///< with w < ln(1/100)
    double multiplier = 0;  ///< largest Floquet multiplier as the secants see it
    int turns = 0;
    long steps = 0;
};

struct Settings {
    double rtol = 1e-8;
    double floor = probe;  ///< size of the small disturbance: its phase has tolerances relative to it
    int turn_limit = 40;   ///< of the cycle search; beyond, the point is left over
    long step_limit = 100000;
};

/// How wide the lanes of this processor are, as chosen at run time.
enum class Instructions : std::uint8_t { baseline, avx2, avx512 };
Instructions best_instructions();

/// Answers every job, one after another in lanes that are refilled as they fall free. Each answer depends on its job
/// and the settings alone, bit by bit, for a given instruction set. Allocates nothing. Any number may run side by side.
void run(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, Instructions instructions);

}  // namespace stickslip::lanes
