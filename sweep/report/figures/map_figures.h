// The charts over swept axes, with the words under them.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/map_answer.h"

#include <vector>

namespace stickslip {

/// The chart of a slice: the field as swept, the located boundaries, the design point, and the share of the chart's
/// area (axes as drawn) in which the theories differ.
StabilityMap stability_map(Units units, const Slice& slice, const MapAnswer& answer);

/// The stability map of a slice: regions, both boundaries, layers of a third axis, motions at a few nodes.
Figure map_figure(Units units, const Slice& slice, const MapAnswer& answer, bool design_rests = false);

/// Amplitude, period and time at rest of the limit cycles, where the sweep simulated its points.
std::vector<Figure> outcome_figures(Units units, const Slice& slice, const MapAnswer& answer);

/// The critical position gain over two axes.
Figure surface_figure(const GainSurface& surface, Units units);

/// "map-k-p-k-v": an id made of the last parts of two paths.
std::string chart_id(const char* kind, const Axis& x, const Axis& y);

/// What reproduces one place of a slice, in the folder of the report: a command with {x} and {y} open, and {depth} and
/// {up} for the values of these two paths, where they are not empty.
std::string reproducing_command(const Slice& slice, const std::string& depth = "", const std::string& up = "");

}  // namespace stickslip
