// The turns that the program of one lane has watched.
#pragma once
#include <deque>

#include "analysis/simulation/attractor/repeats.h"
#include "analysis/simulation/lanes/watched_program.h"

namespace stickslip::lanes {

inline double norm(const FlowVector& point)
{
    return point.lpNorm<Eigen::Infinity>();
}

/// States are the unknowns on the section, per scale.
struct WatchedProgram::Watched {
    std::deque<Turn> turns;  ///< newest last
    FlowVector start, end;   ///< of the present turn
    double first_peak = 0;   ///< largest X until the section is first crossed

    int count() const { return static_cast<int>(turns.size()); }
    const FlowVector& point(int i) const { return turns[static_cast<std::size_t>(i)].state; }
    double gap(int i, int j) const { return norm(point(i) - point(j)); }
};

}  // namespace stickslip::lanes
