#include "analysis/simulation/sampled/cycles/stretch.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

void Stretch::add(const Stretch& more)
{
    const LoopTurn& m = more.outer;
    outer.velocity_min = std::min(outer.velocity_min, m.velocity_min);
    outer.velocity_max = std::max(outer.velocity_max, m.velocity_max);
    outer.position_min = std::min(outer.position_min, m.position_min);
    outer.position_max = std::max(outer.position_max, m.position_max);
    outer.rest_time += m.rest_time;
    outer.reversed |= m.reversed;
    ticks += more.ticks, rests += more.rests, rounds += more.rounds;
    sizes += more.sizes, squares += more.squares, changes += more.changes;
    if (!(first_round == first_round)) first_round = more.first_round;
    if (more.last_round == more.last_round) last_round = more.last_round;
}

double Stretch::spread() const
{
    if (rounds < 2) return missing;
    return std::sqrt(std::max(0.0, squares / rounds - size() * size()) * rounds / (rounds - 1));
}

}  // namespace stickslip
