// How far the gap shrinks on data that the fit has not seen.
#pragma once
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/results/note.h"

namespace stickslip::gap {

/// A part of the data that is held out in turn: a whole record, or a third of the only one.
struct Fold {
    std::size_t record = 0;
    double from = -infinity, to = infinity;  ///< s
};
std::vector<Fold> folds_of(const std::vector<Case>& cases);

/// The same for one cause: a record that alone shows an effect is held out in thirds, since the others would leave the
/// effect's numbers open.
std::vector<Fold> folds_for(const std::vector<Case>& cases, const Scales& scales, const Attribution& cause);

/// What a fit may see while a fold is held out: the other records, or the rows outside the block.
std::vector<Case> without(const std::vector<Case>& cases, const Fold& fold);

struct HeldOut {
    std::vector<SignalGap> signals;
    OverallGap overall;
    double gain = 0;                   ///< 1 − after / before
    ConfidenceInterval gain_interval;  ///< smallest and largest over the folds
    std::vector<DiagnosedTrace> traces;
    std::vector<Note> notes;  ///< which records were held out in thirds
};

/// Mean squares of the signals in one held-out part, and its first run, before and after.
struct FoldResult {
    std::vector<SignalSquares> before, after;
    Trace trace_before, trace_after;
};
/// The rows in [from, to) against simulations of the documented joint and of the one with the cause.
FoldResult before_and_after(const Case& c, const Joint& documented, const Joint& after, int runs, double from,
                            double to);
/// The gap of every signal over all held-out parts, and the interval of the parts one by one.
void add_gaps(const std::vector<FoldResult>& results, HeldOut& held);
/// A record and its runs before and after, thinned to what a chart can show.
DiagnosedTrace trace_of(const Case& shown, const Trace& before, const Trace& after);

/// Refits the candidate without each fold (an empty candidate needs no fit), simulates the closed loop there before and
/// after, and compares. `documented` holds the joints before the audit.
HeldOut hold_out(const Fit& fit, const std::vector<Joint>& documented, const Attribution& found, int runs);

}  // namespace stickslip::gap
