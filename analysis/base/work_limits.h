// Limits of work: what a search or a motion may cost before it is reported as undecided, each with its unit, its reason
// and its evidence. They decide no other answer. Tolerances and shares stand with their algorithms.
#pragma once

namespace stickslip::work {

/// Steps of the frequency along which the crossings of a loop with dead time are searched. Reason: the steps grow with
/// the dead time in radians of the fastest mode; this is half a second of computing, and 5000 radians. Evidence: of
/// 5000 random joints one with a dead time of thousands of radians took more than 17 minutes without the limit; with it
/// the joint is undecided after 8 s.
inline constexpr long crossing_steps = 500'000;

/// Places on the imaginary axis at which the scan over a gain that moves the sliding looks at the joint; of joints
/// without delays and tables, roots. Reason: half a second of computing. Evidence: of 300 random joints of
/// reliability_times the slowest scans, of several bodies with delays, took 1.1 s for 400,000. Of 829 scans 45 end
/// within it before they have seen all six decades, 34 of these before four.
inline constexpr double places_of_gain_scan = 150'000;

/// Steps of the solver within one turn of a motion, from one downward crossing of V = V_0 to the next. Reason:
/// thousands are usual; more means time scales so far apart that rounding makes the solver creep.
inline constexpr int steps_of_turn = 100'000;

/// Steps after which CVODE leaves a turn to the one-step method. Reason: a multistep method creeps along vibrations
/// that hardly decay, as of a stiff transmission, for as long as they last.
inline constexpr int multistep_steps_of_turn = 15'000;

/// Times that one turn may come to rest. Reason: a motion that rests more often chatters, and would for ever.
inline constexpr int rests_of_turn = 10'000;

/// Steps of the solver within one piece of a tick of a sampled loop. Reason: as `steps_of_turn`; a piece holds one
/// command, so that tens are usual.
inline constexpr long steps_of_tick = 100'000;

/// Ticks of one motion of a sampled loop. Reason: at 1 kHz, 25 minutes of motion; cycles and growth of joints are seen
/// within minutes.
inline constexpr long ticks_of_motion = 1'500'000;

/// Ticks of dead time of a simulated loop. Reason: the commands on their way are stored, 8 bytes each.
inline constexpr double ticks_of_dead_time = 1e6;

/// Steps and slips of one motion from stop to stop at a set point. Reason: slips that neither end nor settle within
/// them creep, and the map from stop to stop has no answer.
inline constexpr int steps_to_stop = 200'000, slips_to_stop = 10'000;

/// Ticks of one slip at a set point in a sampled loop. Reason: a search follows a hundred slips; hundreds of ticks are
/// usual, and a slip that lasts longer creeps.
inline constexpr long ticks_of_slip = 300'000;

}  // namespace stickslip::work
