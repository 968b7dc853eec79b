// Sets of gains in words: intervals, and what a theory requires of k_v.
#pragma once
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"

#include <string>
#include <vector>

namespace stickslip {

/// The intervals whose ends read differently in words: of differences between two sets, slivers remain where their ends
/// nearly coincide.
std::vector<Interval> that_read_apart(std::vector<Interval> list, Quantity quantity, Units units);

/// "above 55 kN/m", "from 5 kN/m to 8 kN/m, …" of open intervals; "none" of none.
std::string intervals_text(const std::vector<Interval>& list, Quantity quantity, Units units);

/// What a theory requires of k_v, given the set with which it calls sliding stable: "k_{v} > 500 N·s/m", "729 N·s/m <
/// k_{v} < 4.12 kN·s/m" where too much is unstable, too.
std::string required_text(const std::vector<Interval>& stable_k_v, Units units);

}  // namespace stickslip
