// The search for a cycle of stops and slips over the distance at which a slip begins, however slips are simulated.
#pragma once
#include "analysis/base/field.h"
#include "analysis/results/set_point.h"

#include <functional>
#include <optional>

namespace stickslip {

/// Distances from the set point at which slips begin: from `low` to `high` beyond the least one that breaks away,
/// evenly in the logarithm.
struct Starts {
    double least = 0, low = 0, high = 0;
    int last = 0;  ///< from 0

    /// From `low` to a hundred times the larger of `least` and `natural`, a distance of the order of the slips.
    Starts(double least, double low, double natural, int per_decade);
    double distance(int i) const;
};

/// What is said of these starts where none leads to a cycle.
SetPoint no_cycle(const Starts& starts, double dead_zone, SetPointMethod method);

/// ln of a ratio, of a slip that does not cross the set point: less than any that does.
inline constexpr double short_of_it = -50;

/// ln of the distance `beyond` the set point at which a slip from `distance` before it ends, per that one.
double growth_of_distance(double beyond, double distance);

/// What a slip from one start came to: that growth, NaN where no slip follows or its end is not known.
struct TriedStart {
    double growth = missing;
    bool failed = false;  ///< its end is not known: it may be one of a cycle
};

struct SearchedStarts {
    std::optional<SetPoint> answer;  ///< of the first start that was judged to have one
    double largest = -infinity;      ///< growth of those that were tried
    bool all_followed = true;
};

/// From far away inwards until `judged` has an answer for a start and its growth.
SearchedStarts search_starts(const Starts& starts, const std::function<TriedStart(double)>& slip_from,
                             const std::function<std::optional<SetPoint>(double, double)>& judged);

/// Of a search without an answer.
SetPoint no_cycle_found(SetPoint none, const SearchedStarts& searched);

}  // namespace stickslip
