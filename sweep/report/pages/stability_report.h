// The report of a sweep: verdict first, then the numbers with their limits, alerts, charts, and how to reproduce it.
#pragma once
#include "analysis/results/report.h"
#include "sweep/report/figures/multiples.h"
#include "sweep/study/maps.h"
#include "sweep/study/spec.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// What the report needs beyond the spec.
struct SweepSummary {
    std::vector<Slice> slices;           ///< one a chart
    std::optional<Multiples> multiples;  ///< of the first chart, where the sweep has more than two axes
    std::vector<Profile> profiles;       ///< of a sweep along one axis
    std::uint64_t points = 0;
    std::uint64_t undecided = 0;                                 ///< rows with a reason
    std::vector<std::pair<std::string, std::uint64_t>> reasons;  ///< reason in words, number of rows
    std::vector<std::pair<std::string, std::string>> provenance;
};

/// Composes the report of a linear sweep.
Report stability_report(const Spec& spec, const SweepSummary& summary);

}  // namespace stickslip
