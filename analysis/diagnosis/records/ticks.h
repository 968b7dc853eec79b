// A record on the controller's clock: every tick of the loop, the rows that were logged, and what is known of each.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace stickslip::gap {

/// Where the command that drives a prediction comes from.
enum class CommandSource {
    logged,         ///< computed by the controller itself
    reconstructed,  ///< computed from the reference and the measured motion by the joint's controller
    measured,       ///< the measured effort, put in at the mechanism: no controller takes part
    none            ///< neither a command nor a reference: only a rig's friction can be judged
};

/// Where a prediction starts anew, because the ticks before it were left out.
struct Restart {
    std::size_t tick = 0;
    double velocity = 0;
    double integral = 0;  ///< of the controller's error, over what was left out, too
};

/// Arrays of one length, one entry a tick. Ticks between two rows of a slower log have logged = 0.
struct Ticks {
    std::string name;
    std::vector<double> time, step;                 ///< s; step to the next tick
    std::vector<double> reference, reference_rate;  ///< NaN where there is no reference
    std::vector<double> position;                   ///< encoder; rebuilt or interpolated between rows
    std::vector<double> velocity;                   ///< controller's own estimate, NaN where it was not logged
    std::vector<double> command;                    ///< held until the next tick; NaN where it has to be reconstructed
    std::vector<double> effort;                     ///< measured, NaN where it was not
    std::vector<double> supply;                     ///< V, NaN unknown
    std::vector<double> feed_forward, load, inertia;  ///< known of every tick; inertia over the documented; empty: not
    std::vector<double> load_error;                   ///< an example of what `load` is wrong by; empty: exact
    std::vector<std::uint8_t> enabled, logged;
    std::vector<std::size_t> jumps;    ///< ticks with a row after which the reference jumps before the next row
    std::vector<Restart> restarts;     ///< none in a whole record
    std::vector<std::uint8_t> judged;  ///< empty: every row; else 0 where a prediction has only just started anew
    CommandSource source = CommandSource::none;
    int ticks_per_row = 1;
    bool regular = true;             ///< equal steps
    bool lost = false;               ///< rows are missing in an otherwise regular log: ticks without one
    bool rebuilt = false;            ///< positions between rows follow exactly from the logged velocities
    bool reference_rebuilt = false;  ///< the reference follows from the command: see rebuild_reference()
    bool straight_command = false;   ///< of a continuous loop: goes straight from row to row, is not held
    bool noisy_rows = false;         ///< commands and velocities of the rows carry noise that is unknown between them
    bool has_velocity = false, has_effort = false, has_reference = false;
    bool own_velocity = false;  ///< the commands are seen to be made of the logged velocities, of whatever filter
    bool at_rest = true;
    double began = 0;       ///< s, of `time`, which may be any clock: what comes with time counts from here
    double noise_kept = 0;  ///< part of a reading's noise that stays until the next tick, as behind a filter
    double initial_velocity = 0, initial_velocity_error = 0;  ///< standard error
    double initial_acceleration = 0;                          ///< stretches the spring in front of a link that moves
    double initial_integral = 0;  ///< of the controller's error: an excerpt begins amid a record

    double added(std::size_t k) const { return feed_forward.empty() ? 0 : feed_forward[k]; }  ///< to the command
    /// Whether there are ticks whose readings are only interpolated.
    bool unseen_between() const { return (ticks_per_row > 1 && !rebuilt) || lost; }
    /// Whether the controller is better known to have seen the logged velocities than what its filter would make.
    bool velocity_believed() const { return has_velocity && (unseen_between() || own_velocity); }
    /// Others of a slow log have no row.
    bool of_a_row(std::size_t k) const { return k % static_cast<std::size_t>(ticks_per_row) == 0; }
    std::size_t size() const { return time.size(); }
    std::size_t rows() const { return static_cast<std::size_t>(std::count(logged.begin(), logged.end(), 1)); }
    double duration() const { return time.empty() ? 0 : time.back() - time.front(); }
};

// How a record is put on the clock of its loop.
inline constexpr double most_ticks_per_row = 100;  ///< numerical: 10 Hz of a loop at 1 kHz; slower logs see no friction
inline constexpr double slower_log = 1.5;          ///< numerical: ticks a row from which on rows are not ticks
inline constexpr double whole_ticks = 0.02;        ///< numerical: distance to a whole number of ticks: clocks jitter

double median_step(const std::vector<double>& time);

/// Puts a record on the joint's clock (control.period where it is set and divides the log's step, else the rows
/// themselves). Rows that a regular log has lost are ticks without a row. Rows must be sorted and finite in time and
/// position: see inspect() for what is refused and why.
Ticks on_clock(const Record& record, const Joint& joint);

/// The first so many ticks alone.
Ticks first_ticks(const Ticks& ticks, std::size_t count);

/// The reading at tick k − 1 between two rows of a log of every second tick, from its velocities, if these were
/// filtered with this time constant: v_k = v_{k−2}(1−g)² + g(1−g) d_{k−1} + g d_k with g = T/(τ + T), and d_{k−1} + d_k
/// is known.
double between_rows(const Ticks& ticks, std::size_t k, double period, double tau);
/// Puts them in place for the joint's own time constant, on the grid of its encoder.
void rebuild_halves(Ticks& ticks, const Joint& joint);
/// Takes that back, where the velocities turn out to follow no filter.
void interpolate_halves(Ticks& ticks);

/// Lets the reference, or what a rebuilt one makes the controller want, jump at the given tick (1 … ticks_per_row)
/// after the row of `jumps[which]`.
void place_jump(Ticks& ticks, const Control& control, std::size_t which, int after);

}  // namespace stickslip::gap
