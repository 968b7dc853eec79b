// What a report draws from the results of a sweep: slices for its charts, counts, provenance.
#pragma once
#include "analysis/results/point.h"
#include "sweep/engine/plan.h"
#include "sweep/engine/results_file.h"
#include "sweep/study/maps.h"
#include "sweep/study/panels.h"
#include "sweep/study/spec.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// The points of a sweep as its charts need them.
struct SweepSummary {
    std::vector<Slice> slices;           ///< one a chart
    std::optional<Multiples> multiples;  ///< of the first chart, where the sweep has more than two axes
    std::vector<Profile> profiles;       ///< of a sweep along one axis
    std::uint64_t points = 0;
    std::uint64_t interpolated = 0;  ///< rows whose motions were not computed
    std::uint64_t undecided = 0;     ///< rows with a reason
    std::uint64_t held = 0;          ///< rows that the stated disturbance leaves at rest for good
    std::vector<std::pair<Reason, std::uint64_t>> reasons;  ///< and the number of rows with it
    std::vector<std::pair<std::string, std::string>> provenance;
};

/// Fills [report] where the spec leaves it open: k_p against every other axis (or the first two axes), and k_cr(k_v,
/// V0) where both are axes.
void choose_charts(Spec& spec);

/// Reads the slices that the charts need through the grid point nearest to the design, and counts undecided rows.
SweepSummary summarise(const Spec& spec, const ResultsFile& results);

}  // namespace stickslip
