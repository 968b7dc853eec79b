// The first chart of a sweep at several values of the third axis and the fourth.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/stability_panels.h"
#include "sweep/engine/results_file.h"
#include "sweep/study/maps.h"

#include <optional>
#include <span>
#include <vector>

namespace stickslip {

/// The verdicts of the panels as swept, and what the remaining axes are held at.
struct Multiples {
    std::vector<Held> held;
    StabilityPanels panels;  ///< without boundaries, design and words
};

/// At most six values of a third axis, or four of it and three of a fourth: evenly spread, both ends among them, and
/// the one at `at` (indices of the design's grid point). A fine plane is thinned to what a panel can show; what is left
/// are nodes of the sweep. None without a third axis. `x` and `y` are places in the results' axes.
std::optional<Multiples> read_multiples(const ResultsFile& results, std::size_t x, std::size_t y,
                                        std::span<const std::size_t> at);

/// What is computed for the panels: both boundaries in each, and the design as its own panel shows it.
struct PanelsAnswer {
    std::vector<std::vector<Curve>> curves;
    DesignPoint design;
};

PanelsAnswer answer_panels(const Joint& design, const Multiples& multiples);

/// Everything that one panel holds fixed.
inline std::vector<Held> held_in_panel(const Multiples& multiples, const StabilityPanel& panel)
{
    std::vector<Held> held = multiples.held;
    held.push_back({multiples.panels.across, panel.across});
    if (!multiples.panels.up.name.empty()) held.push_back({multiples.panels.up, panel.up});
    return held;
}

/// The further axis that a chart moves along: any but the velocity first, as that one has charts of its own.
/// axes.size() where none is left.
std::size_t further_axis(const std::vector<Axis>& axes, std::initializer_list<std::size_t> taken);

}  // namespace stickslip
