// What one stability chart shows: a field over two axes, curves located beside the grid, the design point.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/results/quantity.h"

namespace stickslip {

/// One axis of a sweep: a dotted path into the joint, its values in SI, and how it is read.
struct Axis {
    std::string path;    ///< "control.k_p"
    std::string symbol;  ///< chart mark-up, "k_{p}"
    std::string name;    ///< "position gain"
    Quantity quantity = Quantity::number;
    bool log = false;
    std::vector<double> values;  ///< ascending
};

/// How a point of a chart is judged. Velocity-only means: friction replaced by its steady-state curve.
enum class Region : std::uint8_t {
    stable,         ///< both theories: smooth
    memory_only,    ///< velocity-only forbids it, memory allows it: the paper's second regime
    velocity_only,  ///< velocity-only allows it, memory forbids it
    unstable,       ///< both theories: stick-slip
    bistable,       ///< linearly stable, yet a larger disturbance ends in stick-slip
    undecided,      ///< with a reason in the row
    neutral         ///< with memory a root lies on the imaginary axis: small disturbances neither decay nor grow
};

/// A boundary located point by point (not contoured from the grid).
struct Curve {
    enum class Kind {
        velocity_only,
        state_variable,
        fold,
        outcome,
        ideal_loop  ///< with memory, under the paper's loop in place of the joint's own
    };
    Kind kind = Kind::state_variable;
    std::vector<double> x, y;  ///< SI; NaN separates pieces
    double precision = 0;      ///< largest relative bracket width of its points
};

/// The marked design and how far each axis may move, alone, before the state-variable boundary is met.
struct DesignPoint {
    double x = 0, y = 0;
    bool inside = true;  ///< lies within the axes
    Region region = Region::undecided;
    double spectral_abscissa = 0;  ///< 1/s, negative decays
};

/// Numbers beside the field of a map, for the reader under the pointer and the CSV file.
struct MapReading {
    std::string name;  ///< "limit-cycle amplitude"
    Quantity quantity = Quantity::number;
    std::vector<double> values;  ///< row-major like StabilityMap::abscissa; NaN where there is none
    std::string column;          ///< its name in results.nc
};

/// A stability map at another value of a third axis.
struct MapLayer {
    double value = 0;
    std::vector<double> abscissa;
    std::vector<Region> region;
    std::vector<Curve> curves;
};

/// The start of a motion at one node of a chart, shown when a reader chooses a place near it.
struct MapMotion {
    double x = 0, y = 0;
    std::vector<double> time, velocity;
};

struct StabilityMap {
    std::string title;  ///< "Stability of sliding over (k_p, k_v)"
    std::string fixed;  ///< what is held, mark-up: "V_{0} = 1 mm/s, force control, …"
    Units units;
    Axis x, y;
    std::vector<double>
        abscissa;                ///< max Re s [1/s], row-major: index = iy * x.values.size() + ix; NaN where undecided
    std::vector<Region> region;  ///< same layout
    std::vector<Curve> curves;
    DesignPoint design;
    bool has_design = false;
    double disagreement = 0;  ///< share of the chart's area (axes as drawn) where the two theories differ
    double undecided = 0;     ///< share of undecided points
    std::vector<MapReading> readings;
    Axis depth;                      ///< a third axis that a page moves along; its name is empty where there is none
    double depth_value = 0;          ///< where this map lies on it
    std::vector<MapLayer> layers;    ///< ascending in value, this map's own among them; empty: no third axis
    std::vector<MapMotion> motions;  ///< with the other axes as in `fixed`
    /// Shell command that reproduces one place; {x}, {y} and {depth} stand for numbers in SI. Empty: none.
    std::string command;
};

/// A number, or a class, over two axes: amplitude, period, what changed between two runs.
struct FieldMap {
    enum class Scale { linear, log, diverging };
    struct Line {
        std::string name;
        std::vector<double> x, y;  ///< SI; NaN separates pieces
        bool dashed = false;
        std::optional<Curve::Kind> boundary = {};  ///< set: in the pen and the words of a stability map's curve
    };
    std::string title, fixed, statement;
    Units units;
    Axis x, y;
    std::string name, symbol;  ///< "limit-cycle amplitude", "x_{a}"
    Quantity quantity = Quantity::number;
    Scale scale = Scale::linear;
    std::vector<double> values;        ///< row-major like StabilityMap::abscissa; NaN where there is none
    std::string none;                  ///< what NaN means, "slides smoothly"
    std::vector<std::string> classes;  ///< not empty: values are indices into this list of at most six
    std::vector<Line> lines;
    DesignPoint design;
    bool has_design = false;
    std::string command;  ///< as in StabilityMap
};

/// k_cr over two axes, for the 3-D picture; NaN where no critical gain exists.
struct CriticalGainSurface {
    std::string title, fixed;
    Units units;
    Axis x, y;
    std::string z_name, z_symbol;  ///< "critical position gain", "k_{cr}"
    Quantity z_quantity = Quantity::position_gain;
    std::vector<double> z;  ///< row-major like StabilityMap::abscissa
};

/// What stands beside an axis of a line chart, mark-up, and the unit of its numbers; "" for none.
struct AxisName {
    std::string name, unit = {};

    /// "velocity V [m/s]"
    std::string text() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

/// A line chart: several named curves over one axis.
struct LineChart {
    struct Line {
        std::string name;
        std::vector<double> x, y;
        bool dashed = false;
    };
    std::string title, fixed;
    AxisName x_label, y_label;
    bool x_log = false, y_log = false;
    std::vector<Line> lines;
    std::vector<std::pair<std::string, double>> x_marks;  ///< vertical marks with a label
};

}  // namespace stickslip
