// The charts over swept axes, with the words under them.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/maps.h"
#include "sweep/study/spec.h"

#include <vector>

namespace stickslip {

/// The stability map of a slice: regions, both boundaries, layers of a third axis, motions at a few nodes.
Figure map_figure(const Joint& joint, const Slice& slice);

/// Amplitude, period and time at rest of the limit cycles, where the sweep simulated its points.
std::vector<Figure> outcome_figures(const Joint& joint, const Slice& slice);

/// The critical position gain over two axes.
Figure surface_figure(const Joint& joint, const Axis& x, const Axis& y);

/// "map-k-p-k-v": an id made of the last parts of two paths.
std::string chart_id(const char* kind, const Axis& x, const Axis& y);

/// What reproduces one place of a slice, in the folder of the report: a command with {x} and {y} open, and {depth} and
/// {up} for the values of these two paths, where they are not empty.
std::string reproducing_command(const Slice& slice, const std::string& depth = "", const std::string& up = "");

}  // namespace stickslip
