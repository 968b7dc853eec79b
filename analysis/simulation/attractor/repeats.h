// Motions that come back after several turns.
#pragma once
#include <deque>
#include <functional>
#include <vector>

#include "analysis/simulation/solvers/motion.h"

namespace stickslip {

inline constexpr int longest_repeat = 32;  ///< turns

/// The least number of turns after which the newest of `count` turns comes back, 0 if none does. `gap(i, j)` is the
/// distance of turns i and j, 0 the oldest; what is still to come of a gap that shrinks counts in, and a repeat after
/// several turns must hold for each of them.
int turns_to_repeat(int count, const std::function<double(int, int)>& gap, double allowed);

/// The same of a motion that there is no work left to watch, by the finest gap per `size` at which it shows; 0 if at
/// none up to a thousandth.
int turns_to_repeat_nearly(int count, const std::function<double(int, int)>& gap, double size);

/// The least number of turns after which the newest turn comes back within `allowed`, closing in or not; 0 if none.
int nearest_return(int count, const std::function<double(int, int)>& gap, double allowed);

/// The newest turns as one.
Turn merged(const std::deque<Turn>& turns, int newest);

/// How many of the newest turns are turns of their own: those that ring within a phase of sticking, small and short,
/// are not.
int full_turns(const std::deque<Turn>& turns, int newest);

/// Whether some of these sizes, one a turn, are larger and some smaller than the one before: what creeps is not.
bool grows_and_shrinks(const std::vector<double>& sizes);

}  // namespace stickslip
