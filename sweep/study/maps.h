// From numbers of a sweep to the charts of a report.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/stability_map.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// A parameter held at a value.
struct Held {
    Axis axis;  ///< its name and unit; values empty
    double value = 0;
};

/// A 2-D slice of a sweep, row-major with x fastest, and what the other axes are held at.
struct Slice {
    Axis x, y;
    std::vector<Held> held;
    std::vector<double> abscissa;  ///< 1/s
    std::vector<Region> region;
    std::vector<MapReading> readings;  ///< what the nonlinear joint does, where the sweep computes it
    Axis depth;                        ///< a third axis to move along; its name is empty where there is none
    std::vector<MapLayer> layers;      ///< this slice among them
};

/// The spectral abscissa along the only axis of a sweep.
struct Profile {
    Axis axis;
    std::vector<Held> held;
    std::vector<double> abscissa;      ///< 1/s
    std::vector<MapReading> readings;  ///< what the nonlinear joint does, where the sweep computes it
};

/// "k_{v} = 10 N·s/m, V_{0} = 1 mm/s"
std::string held_text(const std::vector<Held>& held, Units units);

/// The joint with each held parameter at its value. Throws std::invalid_argument for a path that it lacks.
Joint joint_at(Joint joint, const std::vector<Held>& held);

/// Where a design lies over two axes, and whether inside the chart; its region is left open.
DesignPoint place_over(Joint design, const Axis& x, const Axis& y);

/// The share of a chart that each node stands for, axes as drawn; sums to 1. Row-major like a slice.
std::vector<double> area_shares(const Axis& x, const Axis& y);

}  // namespace stickslip
