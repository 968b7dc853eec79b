// Questions to the lanes, and their answers: plain numbers in the four dimensionless groups.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "analysis/results/point.h"

namespace stickslip::lanes {

/// How the state of a rate-and-state law evolves.
enum class StateLaw : std::uint8_t { slip, ageing };

inline constexpr int most_unknowns = 6;  ///< of a motion: X, the measure w of speed and states of up to two bodies

/// A rate-and-state law with one state on a single mass depends on four numbers only. With X = x/L, w = ln(V/V_0),
/// p = (θ − θ_ss)/A and time in L/V_0:
///   X' = e^w − 1,   M e^w w' = −(c (e^w − 1) + K X + w + p),
///   p' = −e^w (p + β w) under the slip law, β (e^(−p/β) − e^w) under the ageing law.
/// About steady sliding both are one.
struct Groups {
    double K;     ///< k_p L/A
    double M;     ///< m V_0²/(L A)
    double beta;  ///< B/A
    double c;     ///< k_v V_0/A
    StateLaw law = StateLaw::slip;
    bool operator==(const Groups&) const = default;
};

/// One motion to follow. What small disturbances do follows from the slow eigenvalue.
struct Job {
    Groups groups;
    double rate;             ///< real part of the slow eigenvalue: small disturbances grow where it is positive
    double frequency;        ///< its imaginary part, not negative
    bool stated;             ///< `start` is a disturbance of stated size; otherwise a small one, lifted along its mode
    double start[3];         ///< X, w, p; a lifted one is followed only where small disturbances grow
    bool search;             ///< where the disturbance decays, also follow a start from near rest
    double rest_start[3];    ///< that start
    bool side_only = false;  ///< whether a stated disturbance decays is all that is asked
};

enum class Ending : std::uint8_t {
    decays,     ///< back to steady sliding; the search, if there was one, found no cycle
    cycle,      ///< small disturbances grow into this cycle
    bistable,   ///< small disturbances decay, a larger one ends in this cycle
    leaves,     ///< small disturbances decay, the stated one does not; in what it ends was not asked
    undecided,  ///< small disturbances grow into a motion that was watched for as long as any is, and found no end
    left_over   ///< not for the lanes: the reference must decide
};

struct Answer {
    Ending ending = Ending::left_over;
    double w_min = 0, w_max = 0;  ///< of the cycle, like all that follows
    double x_min = 0, x_max = 0;
    double period = 0;
    double rest_time = 0;   ///< with w < ln(1/100)
    double multiplier = 0;  ///< largest Floquet multiplier as the secants see it
    double peak = missing;  ///< largest X of the first turn of a stated disturbance, its start included
    bool reached = false;   ///< the stated disturbance itself ended in the cycle
    int turns = 0;
    long steps = 0;
};

struct Settings {
    double rtol = 1e-8;
    double coarse = 1e-3;          ///< tolerance of searches that are expected to see every turn lose much
    double rough = 1e-5;           ///< tolerance of searches whose outcome is then refined or is clear without
    int turn_limit = 40;           ///< of the cycle search; beyond, the point is left over
    int patient_turn_limit = 400;  ///< of a stated disturbance that may decay, turn by turn
    int watched_turns = 3000;      ///< of a motion that is watched until it repeats
    double work = HUGE_VAL;        ///< the same in units of Work
    long step_limit = 100000;
};

/// How wide the lanes of this processor are, as chosen at run time.
enum class Instructions : std::uint8_t { baseline, avx2, avx512 };
Instructions best_instructions();

/// Answers every job, one after another in lanes that are refilled as they fall free. Each answer depends on its job
/// and the settings alone, bit by bit, for a given instruction set. Allocates nothing. Any number may run side by side.
void run(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, Instructions instructions);

}  // namespace stickslip::lanes
