// One axis as numbers: where a value lies, where the ticks stand, how they read.
#pragma once
#include "analysis/results/stability_map.h"

#include <string>
#include <vector>

namespace stickslip::drawing {

/// A stretch of the real line laid over [0, 1].
struct Scale {
    double low = 0, high = 1;
    bool log = false;

    /// Where a value lies; beyond [0, 1] when outside. On a log scale values ≤ 0 give −∞ or NaN.
    double at(double value) const;
    double value(double position) const;
};

/// The range of all finite values, widened when it is a single point. A log scale asks for positive values.
/// Throws std::invalid_argument otherwise.
Scale spanning(const std::vector<double>& values, bool log);

struct Tick {
    double value = 0;   ///< in the scale's own unit
    std::string label;  ///< mark-up
};

struct Ticks {
    std::vector<Tick> major;
    std::vector<double> minor;
};

/// Ticks for an axis with room for about `room` labels. `divisor` takes values to the printed unit (1000 for kN/m).
/// Log: powers of ten with every 2…9 minor; 1, 2, 5 labelled where there are fewer than two powers.
/// Linear: steps of 1, 2 or 5 times a power of ten, minor ones between.
Ticks ticks(const Scale& scale, int room, double divisor = 1);

/// How an axis is written: "position gain k_{p} [kN/m]" and what to divide its values by.
struct AxisLabel {
    std::string text;  ///< mark-up
    double divisor = 1;
};

/// A log axis keeps the unit itself, its labels carry the power of ten; a linear one takes the prefix that leaves its
/// labels short.
AxisLabel axis_label(const std::string& name, const std::string& symbol, Quantity quantity, Units units,
                     const Scale& scale);

/// The same of a line chart's axis.
AxisLabel axis_label(const AxisName& axis, const Scale& scale);

}  // namespace stickslip::drawing
