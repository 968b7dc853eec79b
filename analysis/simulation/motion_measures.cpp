#include "analysis/simulation/motion_measures.h"

#include <algorithm>
#include <cmath>

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

void measure_stairs(MotionMeasures& m, Rows time, Rows reference, Rows position, std::size_t stop)
{
    bool stopped = false;
    double first_time = 0, first_place = 0, last_time = 0, last_place = 0;
    for (std::size_t i = 1; i <= stop; ++i) {
        const double asked = std::abs(reference[i] - reference[i - 1]), made = std::abs(position[i] - position[i - 1]);
        if (asked == 0) continue;
        if (!stopped && made < stop_share * asked) {
            stopped = true;
            last_time = time[i], last_place = position[i];
            if (m.stairs++ == 0) first_time = last_time, first_place = last_place;
        } else if (stopped && made > go_share * asked) {
            stopped = false;
        }
    }
    if (m.stairs < 2) return;
    m.stair_height = std::abs(last_place - first_place) / (m.stairs - 1);
    m.stair_rate = (m.stairs - 1) / (last_time - first_time);
}

}  // namespace

MotionMeasures measure_motion(Rows time, Rows reference, Rows position)
{
    MotionMeasures m;
    if (time.size() < 2) return m;
    m.travel = reference.back() - reference.front();
    m.final_error = reference.back() - position.back();
    const std::size_t stop = last_move(reference);
    if (m.travel != 0 && stop + 1 < time.size()) measure_arrival(m, time, reference, position, stop);
    measure_stairs(m, time, reference, position, stop);
    return m;
}

}  // namespace stickslip
