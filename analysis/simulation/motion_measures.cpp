#include "analysis/simulation/motion_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip {
namespace {

using Rows = std::span<const double>;

/// The last row in which the reference still moves; 0: it never does.
std::size_t last_move(Rows reference)
{
    std::size_t last = 0;
    for (std::size_t i = 1; i < reference.size(); ++i)
        if (reference[i] != reference[i - 1]) last = i;
    return last;
}

void measure_arrival(MotionMeasures& m, Rows time, Rows reference, Rows position, std::size_t stop)
{
    const double goal = reference.back(), direction = m.travel < 0 ? -1 : 1;
    m.overshoot = 0;
    for (const double y : position) m.overshoot = std::max(m.overshoot, direction * (y - goal));
    const double band = settled_share * std::abs(m.travel);
    std::size_t outside = position.size();  // the last row out of the band, plus one
    while (outside > 0 && std::abs(position[outside - 1] - goal) <= band) --outside;
    if (outside < position.size()) m.settling_time = std::max(0.0, time[outside] - time[stop]);
}

/// Of the largest position: less between two rows is mostly their rounding, and says nothing of a speed.
constexpr double told_apart = 1e3 * std::numeric_limits<double>::epsilon();

double largest(Rows values)
{
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

/// A stop is one of a stair where the joint moved before it and moves on after it, both in the reference's direction:
/// at a turning point every joint stands. Speeds are those between rows over which the reference moves by more than the
/// rounding of positions, as solvers take steps of 1e-16 s where a slip begins, and by so much that a stop is more than
/// an error of the readings.
void measure_stairs(MotionMeasures& m, Rows time, Rows reference, Rows position, std::size_t stop, double reading_error)
{
    bool stopped = false, moved = false, of_a_stair = false, after_a_stair = false, forward = true;
    double stop_time = 0, stop_place = 0, last_time = 0, last_place = 0, heights = 0, durations = 0;
    int steps = 0;
    const double rounding = told_apart * std::max(largest(reference), largest(position));
    const double least = std::max(rounding, 2 * reading_error / stop_share);
    for (std::size_t i = 1, from = 0; i <= stop; ++i) {
        if (reference[i] == reference[i - 1]) from = i;  // stands: what is made meanwhile is no stair's
        const double commanded = reference[i] - reference[from], made = std::abs(position[i] - position[from]);
        if (std::abs(commanded) <= least) continue;
        from = i;
        if ((commanded > 0) != forward) forward = commanded > 0, moved = of_a_stair = after_a_stair = false;
        if (!stopped && made < stop_share * std::abs(commanded)) {
            stopped = true, of_a_stair = moved;
            stop_time = time[i], stop_place = position[i];
        } else if (made > go_share * std::abs(commanded)) {
            moved = true;
            if (!stopped) continue;
            stopped = false;
            if (!of_a_stair) continue;
            ++m.stairs;
            if (after_a_stair)
                heights += std::abs(stop_place - last_place), durations += stop_time - last_time, ++steps;
            last_time = stop_time, last_place = stop_place, after_a_stair = true;
        }
    }
    if (steps == 0) return;
    m.stair_height = heights / steps;
    m.stair_rate = steps / durations;
}

}  // namespace

MotionMeasures measure_motion(Rows time, Rows reference, Rows position, double reading_error)
{
    MotionMeasures m;
    if (time.size() < 2) return m;
    m.travel = reference.back() - reference.front();
    m.final_error = reference.back() - position.back();
    const std::size_t stop = last_move(reference);
    if (m.travel != 0 && stop + 1 < time.size()) measure_arrival(m, time, reference, position, stop);
    measure_stairs(m, time, reference, position, stop, reading_error);
    return m;
}

MotionMeasures per_reading(MotionMeasures m, double scale)
{
    m.travel /= scale, m.final_error /= scale;
    m.overshoot /= std::abs(scale), m.stair_height /= std::abs(scale);
    return m;
}

}  // namespace stickslip
