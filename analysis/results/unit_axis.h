// An axis of a chart in scaled coordinates: the unit interval, a logarithmic axis by its logarithm.
#pragma once
#include "analysis/results/stability_map.h"

#include <cmath>

namespace stickslip {

/// One axis of a chart between its first and last value, as [0, 1].
struct UnitAxis {
    double low, high;
    bool log;

    explicit UnitAxis(const Axis& axis)
        : low(axis.values.front()), high(axis.values.back()), log(axis.log && axis.values.front() > 0)
    {
    }
    double value(double u) const
    {
        if (u == 0) return low;
        if (u == 1) return high;
        if (!log) return low + u * (high - low);
        const double ratio = high / low;
        return std::isfinite(ratio) ? low * std::pow(ratio, u) : std::exp(std::log(low) + u * span());
    }
    double unit(double v) const { return log ? span_to(v) / span() : (v - low) / (high - low); }
    /// What a relative change `share` of the value at u is in units.
    double unit_width(double u, double share) const
    {
        return log ? share / span() : share * std::abs(value(u)) / (high - low);
    }
    /// A width below which a value of the axis is zero to a user: a boundary there can have no relative bracket.
    double least_width() const { return log ? 0 : 1e-24 * (high - low); }
    /// What a logarithmic axis covers, ln(high/low); the ends of an axis may lie further apart than the largest number.
    double span() const { return span_to(high); }

  private:
    double span_to(double v) const
    {
        const double ratio = v / low;
        return std::isfinite(ratio) ? std::log(ratio) : std::log(v) - std::log(low);
    }
};

}  // namespace stickslip
