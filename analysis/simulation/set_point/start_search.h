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
    /// The same, ten times as far at the same density.
    Starts further() const;
};

/// How the starts of a loop are looked at.
struct StartSearch {
    int per_decade = 8;
    bool unstable = false;  ///< while it moves: from far enough it diverges, whatever it does nearby
    bool by_start = true;   ///< also what every start comes to, where that differs
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

/// What one slip came to: its end for good, or the signed position at which the next one begins.
struct SlipEnd {
    double x = missing;
    std::optional<StartEnd> end;
};

/// The answer with what its starts at `side` of the set point come to, slip by slip, and where the loop is unstable
/// those further out, until one diverges. One that goes on is taken to hunt for ever once it has come within the stops
/// of the answer, or after many slips. What is nearer than the least start rests.
SetPoint with_ends(SetPoint answer, Starts starts, double side, const StartSearch& search,
                   const std::function<SlipEnd(double)>& slip_from);

/// Of a search without an answer.
SetPoint no_cycle_found(SetPoint none, const SearchedStarts& searched);

}  // namespace stickslip
